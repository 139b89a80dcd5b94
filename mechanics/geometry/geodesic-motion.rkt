#lang racket/base
;; Geodesics followed in time, and vectors carried along curves.
;;
;; In a chart a geodesic has the accelerations −Σ Γᵃ_bk vᵇ vᵏ; a vector u that is carried parallel
;; along a curve with velocity v changes at the rates −Σ Γᵃ_bk uᵇ vᵏ.  Of a metric the first are
;; Lagrange's equations of ½ g(v, v).

(require "chart-calculus.rkt" "component-array.rkt" "connection.rkt" "basis.rkt"
         "manifold-chart.rkt" "metric.rkt" "motion-on-manifold.rkt" "tensor-field.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/local-tuple.rkt"
         "../motion/evolve-trajectory.rkt"
         "../value/shape.rkt")

(provide metric->Lagrangian geodesic-state-derivative evolve-geodesic evolve-parallel-transport)

;; (t, q, v) ↦ ½ g(v, v) in the coordinates of C
(define-printed (metric->Lagrangian g C)
  (check-metric 'metric->Lagrangian g)
  (check-coordinate-system 'metric->Lagrangian C)
  (lambda (local)
    (define n (coordinate-system-dimension C))
    (define G (evaluate-components (components-in g C) C (coordinate local)))
    (define v (list->vector (scalars (velocity local))))
    (g:* 1/2 (quadratic G v v n))))

;; Σ Mᵢⱼ uⁱ vʲ
(define (quadratic M u v n)
  (sum-over n (lambda (i)
                (times (vector-ref u i)
                       (sum-of-products n (lambda (j) (component M n (list i j)))
                                        (lambda (j) (vector-ref v j)))))))

;; c : a metric or a connection -> C -> coefficients there
(define (coefficients-of who c C)
  (cond [(metric? c)
         (connection-coefficients (metric->Cartan c (coordinate-system->basis C)) C)]
        [(Cartan? c) (connection-coefficients c C)]
        [else (complain-of-argument who "a metric or a connection" c)]))

;; −Σ Γᵃ_bk uᵇ vᵏ at the coordinates q, a tuple like u
(define (turning Gamma C q u v)
  (define n (coordinate-system-dimension C))
  (define G (evaluate-components Gamma C q))
  (define us (list->vector (scalars u)))
  (define vs (list->vector (scalars v)))
  (list->structure
   u
   (for/list ([a (in-range n)])
     (define block (for/vector #:length (* n n) ([i (in-range (* n n))])
                     (vector-ref G (+ (* a n n) i))))
     (g:- (quadratic block us vs n)))))

;; (up t q v) -> (up 1 v a), of a metric or a connection
(define-printed (geodesic-state-derivative c C)
  (check-coordinate-system 'geodesic-state-derivative C)
  (define Gamma (coefficients-of 'geodesic-state-derivative c C))
  (lambda (local)
    (define v (velocity local))
    (up 1 v (turning Gamma C (coordinate local) v v))))

;; state : (up t q v) in the chart C, or with a point for q.  t is the parameter of the geodesic.
(define-plain (evolve-geodesic c C state end
                               #:events [events '()] #:charts [charts #f]
                               #:tolerance [tolerance #f] #:method [method #f]
                               #:longest-step [longest +inf.0])
  (define who 'evolve-geodesic)
  (check-coordinate-system who C)
  (follow-in-charts who (lambda (B) (geodesic-state-derivative c B)) C state end events charts
                    tolerance method longest))

;; path : time -> coordinates in C;  u : the vector at the time `from`, an up tuple of components
;; -> a trajectory of states (up t u)
(define-plain (evolve-parallel-transport c C path u from to
                                         #:tolerance [tolerance #f])
  (define who 'evolve-parallel-transport)
  (check-coordinate-system who C)
  (check-argument who procedure? path "a path: a function from the time to coordinates")
  (define n (coordinate-system-dimension C))
  (unless (= n (length (scalars u)))
    (complain who "a vector has ~a components here\n  given: ~a" n (describe-with-value u)))
  (define Gamma (coefficients-of who c C))
  (define (rates state)
    (define t (time state))
    (define-values (q v) (value-and-derivative-along path t 1))
    (up 1 (turning Gamma C q (coordinate state) v)))
  (evolve-trajectory rates (up from u) to #:tolerance tolerance))
