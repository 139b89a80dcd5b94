#lang racket/base
;; Functions of one argument that print as the call that made them, and the datum of such a call.

(require "describe.rkt" "function.rkt")

(provide printed-function define-printed call-datum)

;; (printed-function (name argument ...) (x) body ...) : the function x ↦ body, which prints as
;; (name argument ...), with the arguments' values.
(define-syntax-rule (printed-function (name argument ...) (x) body0 body ...)
  (unary-function (lambda () (list 'name (value->datum argument) ...)) (x) body0 body ...))

;; (define-printed (name argument ...) form ... (lambda (x) body ...)) : name gives such a function
(define-syntax define-printed
  (syntax-rules (lambda)
    [(_ (name argument ...) form ... (lambda (x) body0 body ...))
     (define (name argument ...)
       form ...
       (printed-function (name argument ...) (x) body0 body ...))]))

;; -> the procedure that makes the datum of the call (who argument ...), for make-function
(define ((call-datum who . arguments)) (cons who (map value->datum arguments)))
