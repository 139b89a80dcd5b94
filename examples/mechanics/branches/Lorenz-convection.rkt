#lang mechanics
;; Lorenz's model of a fluid that is heated from below.  Rest gives way to a steady roll where rho
;; is 1, and the roll is stable up to a point of Hopf's at 470/19.  The orbits that begin there go
;; back to smaller rho and are unstable: so the motion jumps away, and is chaotic.

(define ((Lorenz rho) (up x y z))
  (up (* 10 (- y x)) (- (* x (- rho z)) y) (- (* x y) (* 8/3 z))))

(define rest (continue-equilibrium Lorenz (up 0 0 0) 0 30))
rest
(define roll (switch-branch rest (car (branch-special-points rest))))
roll
(define Hopf (car (branch-special-points roll)))
(define orbits (switch-branch roll Hopf #:most-steps 250))
orbits

(module+ test
  (require rackunit)
  (test-case "the point and its frequency are where the characteristic polynomial has them"
    (check-eq? (special-point-kind Hopf) 'Hopf)
    (check-= (special-point-parameter Hopf) 470/19 1e-8)
    (check-= (apply max (map imag-part (special-point-spectrum Hopf)))
             (sqrt (* 8/3 (+ 10.0 470/19))) 1e-6))
  ;; C. Sparrow, The Lorenz Equations (1982): down to 13.926, where the orbit meets the origin
  (test-case "the orbits last below the point, are unstable, and ever slower"
    (check-true (< 13.926 (car (reverse (branch-parameters orbits))) 16))
    (check-false (memv #t (branch-stabilities orbits)))
    (define periods (branch-periods orbits))
    (check-true (< (car periods) 1 2 (car (reverse periods))))))
