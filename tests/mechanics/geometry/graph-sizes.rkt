#lang racket/base
;; Components stay graphs with shared nodes: how many nodes curvature has, none of which explodes.
;; The metrics are those of the benchmarks.

(require (except-in mechanics vector-map) mechanics/geometry
         mechanics/algebra/expression/expression
         (only-in mechanics/algebra/expression/flat-graph graph-size)
         (only-in mechanics/algebra/expression/operation op:up)
         (only-in mechanics/geometry/tensor-field components-in)
         "../bench/curvature.rkt"
         "../support/checks.rkt")

(define (nodes T C) (graph-size (make-node op:up (vector->list (components-in T C)))))

(define-check (check-nodes T C limit)
  (define n (nodes T C))
  (with-check-info (['nodes n] ['limit limit])
    (unless (<= n limit) (fail-check))))

(define (Riemann-of g C)
  (Riemann (covariant-derivative (metric->Cartan g (coordinate-system->basis C)))))

(test-case "metrics of black holes and of an expanding universe"
  (define C spacetime-sphere)
  (for ([g (list (Schwarzschild-metric) (Kerr-Newman-metric 0) (Kerr-Newman-metric 'Q)
                 (expanding-metric))]
        [of-metric '(25 60 60 30)]
        [of-Riemann '(120 2000 3500 120)]
        [below '(100 1000 1500 120)]
        [of-Ricci '(5 5 1000 70)])
    (check-nodes g C of-metric)
    (check-nodes (Riemann-of g C) C of-Riemann)
    (check-nodes (metric->Riemann g) C below)
    (check-nodes (Ricci-of g) C of-Ricci)))

(test-case "empty space has 0 for each component of Ricci's tensor"
  (for ([g (list (Schwarzschild-metric) (Kerr-Newman-metric 0))])
    (for ([c (in-vector (components-in (Ricci-of g) spacetime-sphere))]) (check-eqv? c 0))))

(test-case "a metric of 4 dimensions of which nothing is known"
  (define R (literal-curvature))
  (check-nodes R R4-rect 4000)
  (for ([T (curvature-identities R)]) (check-nodes T R4-rect 5000))
  (check-nodes (Riemann-of (literal-metric 'g R4-rect) R4-rect) R4-rect 80000))
