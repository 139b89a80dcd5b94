#lang racket/base
;; Functional Differential Geometry, chapter 1: free motion on a surface, by Lagrange's equations
;; and by the connection of the metric.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates t R1-rect)

(define ((L-free mass) state) (* 1/2 mass (square (velocity state))))

(define ((sphere->R3 R) state)
  (define q (coordinate state))
  (define-values (theta phi) (values (ref q 0) (ref q 1)))
  (up (* R (sin theta) (cos phi)) (* R (sin theta) (sin phi)) (* R (cos theta))))

(define (L-sphere m R) (compose (L-free m) (F->C (sphere->R3 R))))

(test-case "1.1: the Lagrangian of a free particle on a sphere"
  (check-prints ((L-sphere 'm 'R) (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
                '(* 1/2 m (expt R 2)
                    (+ (* (expt phidot 2) (expt (sin theta) 2)) (expt thetadot 2)))))

;; ---------------------------------------------------------------------------

(define ((L2 mass metric) place velocity) (* 1/2 mass ((metric velocity velocity) place)))

(define ((Lc mass metric chart) state)
  (define e (coordinate-system->vector-basis chart))
  ((L2 mass metric) ((point chart) (coordinate state)) (* e (velocity state))))

(define the-metric (literal-metric 'g R2-rect))
(define L (Lc 'm the-metric R2-rect))

(test-case "1.2: the Lagrangian of a literal metric"
  (check-prints (L (up 't (up 'x 'y) (up 'vx 'vy)))
                '(+ (* m vx vy (g_01 (up x y)))
                    (* 1/2 m (+ (* (expt vx 2) (g_00 (up x y)))
                                (* (expt vy 2) (g_11 (up x y))))))))

(define gamma (literal-manifold-map 'q R1-rect R2-rect))
(define coordinate-path (compose (chart R2-rect) gamma (point R1-rect)))

(test-case "1.3: a literal path, and its coordinates"
  (check-prints ((chart R2-rect) (gamma ((point R1-rect) 't))) '(up (q^0 t) (q^1 t)))
  (check-prints (coordinate-path 't) '(up (q^0 t) (q^1 t))))

(define basis (coordinate-system->basis R2-rect))
(define Cartan (Christoffel->Cartan (metric->Christoffel-2 the-metric basis)))

(test-case "1.4: Lagrange's residual is the mass times the metric times that of the geodesic"
  (define residual (((Lagrange-equations L) coordinate-path) 't))
  (define geodesic-residual
    (((((covariant-derivative Cartan gamma) d/dt) ((differential gamma) d/dt)) (chart R2-rect))
     ((point R1-rect) 't)))
  (define components (metric->components the-metric basis))
  (check-identity residual
                  (* (* 'm (components (gamma ((point R1-rect) 't)))) geodesic-residual)))
