#lang mechanics
;; Exercise 9.7 (FDG 9): circular orbits about a black hole
;; Checked: they obey Kepler's law to the letter, ω² r³ = GM
;; How: the geodesic equation along a circle

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define a (- 1 (/ (* 2 'G 'M) (* (square 'c) r))))
(define (metric u v)
  (+ (* -1 (square 'c) a (dt u) (dt v)) (* (/ 1 a) (dr u) (dr v))
     (* (square r) (+ (* (dtheta u) (dtheta v)) (* (square (sin theta)) (dphi u) (dphi v))))))
(define connection (metric->Cartan metric basis))

;; Round over the poles, by the time of far clocks
(define (orbit omega)
  (compose (point spacetime-sphere) (lambda (t) (up t 'r (* omega t) 0)) (chart R1-rect)))
(define (residual omega)
  ((((geodesic-equation R1-rect spacetime-sphere connection) (orbit omega))
    (chart spacetime-sphere))
   ((point R1-rect) 't)))

;; Along r there is one equation for ω.
(define along-r (ref (residual 'omega) 1))
along-r
(define right (verify-equal (residual (sqrt (/ (* 'G 'M) (cube 'r)))) (up 0 0 0 0)))
right

;; The slip: the radius as far as a = 0 taken off
(define wrong
  (verify-equal (residual (sqrt (/ (* 'G 'M) (cube (- 'r (/ (* 2 'G 'M) (square 'c)))))))
                (up 0 0 0 0)))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "Kepler's law"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved?
                (verify-equal along-r
                              (* (- (square 'omega) (/ (* 'G 'M) (cube 'r)))
                                 (- (/ (* 2 'G 'M) (square 'c)) 'r))))))
