#lang racket/base
;; Instructions of programs, and the places of their values.

(provide (struct-out place)
         instruction-operation instruction-operands first-operand second-operand
         system-unknowns symmetric-system?)

;; An input or the value of an instruction.  Transparent: two of one index are
;; the same operand.
(struct place (index) #:transparent)

;; (operation operand ...).  The operations are add, subtract, multiply, divide,
;; negate, functions under their own names, and solve, of a system [A b] given row
;; by row, followed at once by its components: (component system k).
(define (instruction-operation i) (car i))
(define (instruction-operands i) (cdr i))
(define (first-operand i) (cadr i))
(define (second-operand i) (caddr i))

;; Of a system: n rows of n + 1 entries.
(define (system-unknowns i) (integer-sqrt (length (instruction-operands i))))

;; Is it known to be symmetric?
(define (symmetric-system? i)
  (define n (system-unknowns i))
  (define entries (list->vector (instruction-operands i)))
  (define (entry row column) (vector-ref entries (+ (* row (+ n 1)) column)))
  (for*/and ([row (in-range n)] [column (in-range row)])
    (equal? (entry row column) (entry column row))))
