#lang racket/base
;; Checks of functions that a reader gives: how many arguments they take, and that their value is
;; a number.

(require "describe.rkt" "function.rkt" "scalar.rkt" "up-down.rkt"
         "../error/complain.rkt")

(provide plain-procedure? takes-arguments? check-takes check-scalar-value)

;; Is x a procedure and no tuple, which answers `procedure?`, too?
(define (plain-procedure? x) (and (procedure? x) (not (tuple? x))))

;; Is f a procedure that accepts n arguments?
(define (takes-arguments? f n) (and (procedure? f) (accepts? f n)))

;; what : a sentence on the argument expected, followed by "; given f"
(define (check-takes who f n what)
  (unless (takes-arguments? f n)
    (complain who "~a; given ~a" what (describe-function f))))

;; -> value, the value of f, which must be a number as that of every `what` is
;; hint : value -> further lines of the message
(define (check-scalar-value who what f value [hint (lambda (value) "")])
  (unless (scalar? value)
    (complain who "the value of ~a is a number, but that of ~a is ~a~a"
              what (value->text f) (describe-with-value value) (hint value)))
  value)
