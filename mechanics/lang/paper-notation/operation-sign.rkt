#lang racket/base
;; The signs of operations, which stand between operands on paper, and functions of one argument.

(require "../../operation/operation-column.rkt")

(provide sign? infix? functions)

(define functions
  (append '(square cube) (operation-names function reciprocal)))

(define (sign? x) (and (memq x '(= < > <= >= + - * / ^ **)) #t))

;; Is a list of forms, data, a formula with a sign after its first operand?
(define (infix? forms)
  (and (pair? forms) (pair? (cdr forms))
       (not (sign? (car forms)))
       (sign? (cadr forms))))
