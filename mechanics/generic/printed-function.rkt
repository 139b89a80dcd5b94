#lang racket/base
;; Functions that print as the call that made them, and are told by it.

(require "describe.rkt" "function.rkt")

(provide printed-function define-printed call-datum made-by)

;; (printed-function (name argument ...) (x) body ...) : the function x ↦ body, which prints as
;; (name argument ...), with the arguments' values.
(define-syntax-rule (printed-function (name argument ...) (x) body0 body ...)
  (unary-function (call-datum 'name argument ...) (x) body0 body ...))

;; (define-printed (name argument ...) form ... (lambda (x) body ...)) : name gives such a function
(define-syntax define-printed
  (syntax-rules (lambda)
    [(_ (name argument ...) form ... (lambda (x) body0 body ...))
     (define (name argument ...)
       form ...
       (printed-function (name argument ...) (x) body0 body ...))]))

;; -> the procedure that makes the datum of the call (who argument ...), for make-function
(define (call-datum who . arguments) (call who arguments))

(struct call (who arguments)
  #:authentic
  #:property prop:procedure
  (lambda (c) (cons (call-who c) (map value->datum (call-arguments c)))))

;; -> the name of the procedure that made the function f by such a call; #f of other values
(define (made-by f)
  (define make (and (function? f) (function-make-datum f)))
  (and (call? make) (call-who make)))
