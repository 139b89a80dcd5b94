#lang racket/base
;; Functions with keywords, to be loaded on demand.
;;
;; `define` makes a macro of such a function, so that a call of it costs nothing more than
;; one without.  A module that loads it on demand gains nothing by that; and to find out
;; that it is a macro, Racket instantiates all that the program needed when it was
;; compiled: some 40 ms at the first call.  What is defined here is a variable.

(provide define-plain)

;; (define-plain (name argument ...) body ...)
(define-syntax-rule (define-plain (name . arguments) body ...)
  (define-values (name) (lambda arguments body ...)))
