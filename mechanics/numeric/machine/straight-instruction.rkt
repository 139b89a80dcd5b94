#lang racket/base
;; Instructions of straight flonum code, and the places of their values.

(provide (struct-out place)
         instruction-operation instruction-operands first-operand second-operand)

;; An input or the value of an instruction.  Transparent: two of one index are
;; the same operand.
(struct place (index) #:transparent)

;; (operation operand ...), operands being places and numbers.  The operations are add, subtract,
;; multiply, divide, negate, and functions under their own names.
(define (instruction-operation i) (car i))
(define (instruction-operands i) (cdr i))
(define (first-operand i) (cadr i))
(define (second-operand i) (caddr i))
