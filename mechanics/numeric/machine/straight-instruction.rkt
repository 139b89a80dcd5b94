#lang racket/base
;; Instructions of flonum programs, and the places of their values.
;;
;; An instruction is a list (operation operand ...).  An operand is a number, or the place of a
;; value: an input, or the value of an earlier instruction.  The operations are
;;
;;     add subtract multiply divide negate     arithmetic
;;     sin, expt ...                           functions, under the algebra's names
;;     larger                                  the second operand where one is no number
;;     solve                                   a linear system [A b], row by row
;;     component                               of a system's solution: (component system k)
;;
;; The components of a system follow it at once.

(provide (struct-out place) value-number
         instruction-operation instruction-operands moved-instruction first-operand second-operand
         system-unknowns symmetric-system?)

;; Prefab: two places of one index are the same operand, and programs are data for other processes.
(struct place (index) #:prefab)

;; Which of the values from one place on an operand is; #f if it is none of these
(define (value-number o from)
  (and (place? o) (>= (place-index o) from) (- (place-index o) from)))

(define (instruction-operation i) (car i))
(define (instruction-operands i) (cdr i))
(define (first-operand i) (cadr i))
(define (second-operand i) (caddr i))

;; The same operation on other operands; moved : operand -> operand
(define (moved-instruction i moved) (cons (car i) (map moved (cdr i))))

;; A system of n unknowns has n rows of n + 1 entries.
(define (system-unknowns i) (integer-sqrt (length (instruction-operands i))))

;; Are the entries of A on both sides of the diagonal the same operands?
(define (symmetric-system? i)
  (define n (system-unknowns i))
  (define entries (list->vector (instruction-operands i)))
  (define (entry row column) (vector-ref entries (+ (* row (+ n 1)) column)))
  (for*/and ([row (in-range n)] [column (in-range row)])
    (equal? (entry row column) (entry column row))))
