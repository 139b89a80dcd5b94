#lang racket/base
;; Procedures that call themselves in messages as the reader calls them.
;;
;; Inside the library `+` is Racket's and the generic one is `g:+`; the name that the
;; reader types, and should read in an error, is `+`.

(provide define-named)

;; Defines id as a procedure whose own name is `name`.
(define-syntax-rule (define-named id name procedure)
  (define id (let ([name procedure]) name)))
