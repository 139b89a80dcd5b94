#lang racket/base
;; Structures made of lists: of the shape of a given one, or a single element without a tuple.

(require "shape.rkt")

(provide list->structure unit-structure single-or)

;; xs : the scalars, in order
(define (list->structure shape xs) (vector->structure shape (list->vector xs)))

;; 1 for the scalar of index k, 0 for the others
(define (unit-structure shape k) (scalars->structure shape (lambda (j) (if (= j k) 1 0))))

;; The only element of the list xs, or (make xs)
(define (single-or make xs) (if (and (pair? xs) (null? (cdr xs))) (car xs) (make xs)))
