#lang racket/base
;; Where a motion ended at a place that is singular in its home chart, all coordinates were those of
;; the last place looked at before, an eighth of a step away, and not only the angle that has no
;; value there.

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/close.rkt")

(define (L-sphere s)
  (* 1/2 (+ (square (ref (velocity s) 0))
            (square (* (sin (ref (coordinate s) 0)) (ref (velocity s) 1))))))
(define (L-plane s)
  (* 1/2 (+ (square (ref (velocity s) 0))
            (square (* (ref (coordinate s) 0) (ref (velocity s) 1))))))

(define (end L chart start time)
  (coordinate (trajectory-final-state (evolve-on L chart start time))))

(test-case "straight to the origin of the plane, at any speed"
  (for ([speed '(1.0 0.01 30.0)])
    (check-close (end L-plane R2-polar (up 0 (up 1.0 0.5) (up (- speed) 0.0)) (/ 1 speed))
                 (up 0 0.5) 1e-8)))

(test-case "along a meridian to either pole"
  (check-close (end L-sphere S2-spherical (up 0 (up 1.0 0.3) (up -1.0 0.0)) 1) (up 0 0.3) 1e-8)
  (check-close (end L-sphere S2-spherical (up 0 (up 1.0 0.3) (up 1.0 0.0)) (- pi 1))
               (up pi 0.3) 1e-8)
  (check-close (end L-sphere S2-spherical (up 0 (up 1.0 0.3) (up 1.0 0.0)) -1) (up 0 0.3) 1e-8))
