#lang racket/base
;; Geodesics followed in time.
;;
;; In a chart a geodesic has the accelerations −Σ Γᵃ_bk vᵇ vᵏ.  Of a metric these are Lagrange's
;; equations of ½ g(v, v).

(require "../chart-calculus.rkt" "../component-array.rkt" "../connection.rkt" "../basis.rkt"
         "../manifold-chart.rkt" "../metric.rkt" "motion-on-manifold.rkt" "../tensor-field.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/define-plain.rkt"
         "../../generic/printed-function.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../motion/integration-failure.rkt" "../../motion/integration-plan.rkt"
         "../../motion/trajectory.rkt"
         "../../value/shape.rkt")

(provide metric->Lagrangian geodesic-state-derivative evolve-geodesic
         coefficients-of turning)

;; (t, q, v) ↦ ½ g(v, v) in the coordinates of C
(define-printed (metric->Lagrangian metric C)
  (define g (as-metric 'metric->Lagrangian metric))
  (check-coordinate-system 'metric->Lagrangian C)
  (check-home 'metric->Lagrangian g C)
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
  (check-metric-or-connection who c C)
  (connection-coefficients (if (metric? c) (metric->Cartan c (coordinate-system->basis C)) c) C))

(define (check-metric-or-connection who c C)
  (check-argument who (lambda (c) (or (metric? c) (Cartan? c))) c "a metric or a connection")
  (when (metric? c) (check-home who c C)))

;; Is the metric one of the manifold of C?
(define (check-home who g C)
  (define home (field-home g))
  (unless (or (not home) (on-one-manifold? home C))
    (complain-showing who "the metric is of another manifold than the chart"
                      "metric of" (coordinate-system-manifold home)
                      "chart of" (coordinate-system-manifold C))))

;; −Σ Γᵃ_bk uᵇ vᵏ at the coordinates q, a tuple like u
(define (turning Gamma C q u v)
  (define n (coordinate-system-dimension C))
  (define G (evaluate-components Gamma C q))
  (define us (list->vector (scalars u)))
  (define vs (list->vector (scalars v)))
  (list->structure
   u
   (for/list ([a (in-range n)])
     (g:- (quadratic (components-from G n a) us vs n)))))

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
  (check-metric-or-connection who c C)
  (with-handlers ([(lambda (e) (and (cut-short? e) (metric? c)))
                   (lambda (e) (explain-degenerate who c C e))])
    (follow-in-charts who (lambda (B) (geodesic-state-derivative c B)) C state end events charts
                      (make-plan who tolerance (check-steps who method) longest)
                      #:Lagrangian (and (metric? c)
                                        (once-a-chart (lambda (B) (metric->Lagrangian c B)))))))

;; e : a motion is cut short.  Where the metric has all but lost a direction, that is the reason.
(define (explain-degenerate who g C e)
  (define tr (trajectory-so-far e))
  (define n (coordinate-system-dimension C))
  (define (determinant t)
    (define G (evaluate-components (components-in g C) C (coordinate (tr t))))
    (abs (determinant-of-matrix G n)))
  (define end (trajectory-end tr))
  (define last-one (determinant end))
  (if (and (real? last-one) (<= last-one (* 1e-4 (determinant (trajectory-start tr)))))
      (raise-singular who "the metric becomes degenerate on the way" (tr end)
                      "time" end
                      "coordinates" (coordinate (tr end))
                      "determinant" last-one)
      (raise e)))
