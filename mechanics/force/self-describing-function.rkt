#lang racket/base
;; Functions of several arguments that print as the expression that made them, and say by it how
;; many they take.

(require "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt")

(provide function-of)

;; (function-of (x ...) make-datum body ...)
(define-syntax-rule (function-of (x ...) make-datum body0 body ...)
  (let ([name make-datum])
    (make-function (case-lambda [(x ...) body0 body ...]
                                [given (raise-takes (name) '(x ...) given)])
                   (arithmetic-shift 1 (length '(x ...)))
                   name)))

(define (raise-takes datum names given)
  (complain-of-arity (value->text datum) "takes ~a arguments, ~a; it was given ~a"
                     (length names) names (if (null? given) "none" (length given))))
