#lang racket/base
;; When has a mass matrix an inverse?
;;
;; Where it has none, Lagrange's equations leave accelerations open: with c = 0 every path is a
;; motion of ½ c v².  The determinant has factors in parameters alone, and none of these may be 0;
;; at special states another factor may vanish.

(require (only-in racket/list append-map)
         "../algebra/expression/symbols.rkt"
         "../algebra/solve/nonzero-conditions.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         "../value/matrix/linear-algebra.rkt")

(provide regular-conditions)

;; M : a matrix, at a local tuple of symbols -> datums, such as (> (abs c) 0)
(define (regular-conditions M local)
  (define A (assumptions-in-force))
  (define (parameter? u) (not (ormap (lambda (name) (occurs? name u)) (scalars local))))
  (append-map (lambda (u) (not-zero u A)) (factors-of (list (determinant M)) A parameter?)))
