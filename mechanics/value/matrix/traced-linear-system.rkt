#lang racket/base
;; Linear systems met while a function is traced, which are left to be solved
;; with numbers: no formula for their solution is as short, or as exact, as an
;; elimination.

(require racket/list
         "../../algebra/expression/expression.rkt"
         (only-in "../../algebra/expression/operation.rkt" op:solution op:component)
         "../../generic/tracing.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide open-system? open-solutions longest-formula)

;; Up to three unknowns, formulas are shorter.
(define longest-formula 3)

(define (open-system? A right)
  (and (being-traced?)
       (> (vector-length A) longest-formula)
       (all-entries? expression? A right)))

;; The rows of x with A x = right.
(define (open-solutions A right)
  (define systems
    (for/list ([b (in-vector (rows-transpose right))])
      (define rows (beside A (rows-transpose (vector b))))
      (make-node op:solution (append-map vector->list (vector->list rows)))))
  (for/vector #:length (vector-length A) ([k (in-naturals)] [_ (in-vector A)])
    (for/vector #:length (length systems) ([s (in-list systems)])
      (make-node op:component (list k s)))))
