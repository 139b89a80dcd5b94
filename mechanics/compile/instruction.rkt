#lang racket/base
;; Instructions of programs: those of straight code, and systems of equations.
;;
;; (solve entry ...) is a system [A b] given row by row, followed at once by its components:
;; (component system k).

(require "../numeric/machine/straight-instruction.rkt")

(provide (all-from-out "../numeric/machine/straight-instruction.rkt")
         system-unknowns symmetric-system?)

;; Of a system: n rows of n + 1 entries.
(define (system-unknowns i) (integer-sqrt (length (instruction-operands i))))

;; Is it known to be symmetric?
(define (symmetric-system? i)
  (define n (system-unknowns i))
  (define entries (list->vector (instruction-operands i)))
  (define (entry row column) (vector-ref entries (+ (* row (+ n 1)) column)))
  (for*/and ([row (in-range n)] [column (in-range row)])
    (equal? (entry row column) (entry column row))))
