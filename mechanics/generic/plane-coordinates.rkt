#lang racket/base
;; Points of the plane as readers give them: tuples of two, or pairs, which the book makes by
;; cons.

(require "up-down.rkt")

(provide plane-coordinates)

;; -> both coordinates of p, or the value of (none)
(define (plane-coordinates p none)
  (cond [(and (tuple? p) (= (structure-length (adopt p)) 2)) (vector->values (tuple-elements p))]
        [(and (pair? p) (not (list? p))) (values (car p) (cdr p))]
        [else (none)]))
