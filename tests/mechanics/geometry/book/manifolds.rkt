#lang racket/base
;; Functional Differential Geometry, chapter 2: manifolds, charts and functions.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define plane (make-manifold R^n 2))
(define U (patch 'origin plane))
(define rect (coordinate-system 'rectangular U))
(define polar (coordinate-system 'polar/cylindrical U))

(test-case "2.1: from chart to chart"
  (check-prints ((compose (chart polar) (point rect)) (up 'x0 'y0))
                '(up (sqrt (+ (expt x0 2) (expt y0 2))) (atan y0 x0)))
  (check-prints ((compose (chart rect) (point polar)) (up 'r0 'theta0))
                '(up (* r0 (cos theta0)) (* r0 (sin theta0))))
  (check-prints ((D (compose (chart rect) (point polar))) (up 'r0 'theta0))
                '(down (up (cos theta0) (sin theta0))
                       (up (* -1 r0 (sin theta0)) (* r0 (cos theta0))))))

(define R2->R '(-> (UP Real Real) Real))
(define f (compose (literal-function 'f-rect R2->R) (chart R2-rect)))
(define R2-rect-point ((point R2-rect) (up 'x0 'y0)))
(define polar-point
  ((point R2-polar) (up (sqrt (+ (square 'x0) (square 'y0))) (atan 'y0 'x0))))

(test-case "2.2: a function on a manifold does not care by which chart its point was given"
  (check-prints (f R2-rect-point) '(f-rect (up x0 y0)))
  (check-prints (f polar-point) '(f-rect (up x0 y0)))
  (define g (literal-manifold-function 'f-rect R2-rect))
  (check-identity (g polar-point) (f R2-rect-point)))

(define-coordinates (up x y) R2-rect)
(define-coordinates (up r theta) R2-polar)

(test-case "2.2: coordinates as functions"
  (check-prints (x ((point R2-polar) (up 'r0 'theta0))) '(* r0 (cos theta0)))
  (check-prints (x R2-rect-point) 'x0)
  (check-prints (r ((point R2-polar) (up 'r0 'theta0))) 'r0)
  (check-prints (r R2-rect-point) '(sqrt (+ (expt x0 2) (expt y0 2))))
  (check-prints (theta R2-rect-point) '(atan y0 x0)))

(test-case "2.2: functions made of coordinates of two charts"
  (define h (+ (* x (square r)) (cube y)))
  (check-prints (h R2-rect-point) '(+ (expt x0 3) (* x0 (expt y0 2)) (expt y0 3)))
  (check-identity (h ((point R2-polar) (up 'r0 'theta0)))
                  (+ (* (cube 'r0) (cube (sin 'theta0))) (* (cube 'r0) (cos 'theta0)))))
