#lang mechanics
;; Exercise 9.1 (FDG 9): the connection that keeps a metric
;; Checked: ∇g = 0 for every metric of four dimensions, and the rule for scalar products
;; How: for unknown components of the metric and of three fields

(require mechanics/geometry)
(define g (literal-metric 'g R4-rect))
(define (connection g) (metric->Cartan g (coordinate-system->basis R4-rect)))
(define nabla (covariant-derivative (connection g)))
(define (field name) (literal-vector-field name R4-rect))
(define-values (v x y) (values (field 'v) (field 'x) (field 'y)))

(define kept (verify-equal ((nabla v) g) 0))
kept

;; So a scalar product changes by what its fields do.
(define products
  (verify-equal (v (g x y)) (+ (g ((nabla v) x) y) (g x ((nabla v) y)))))
products

;; The slip: the connection of another metric
(define other (covariant-derivative (connection (literal-metric 'h R4-rect))))
(define wrong (verify-equal ((other v) g) 0))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "a metric is kept by its own connection"
    (check-pred proved? kept)
    (check-pred proved? products)
    (check-pred refuted? wrong)))
