#lang mechanics
;; A spherical pendulum that goes round on a cone, and how it swings about that.

(define (L (up t (up theta phi) (up thetadot phidot)))
  (+ (* 1/2 'm (square 'l) (+ (square thetadot) (square (* phidot (sin theta)))))
     (* 'm 'g 'l (cos theta))))
(define local (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
(conserved-momenta L local)

;; With p for that momentum, phidot = p/(m l² sin²θ); what is left is a system of one
;; coordinate, with L − p phidot for its Lagrangian.
(define ((L-reduced p) (up t theta thetadot))
  (define phidot (/ p (* 'm (square 'l) (square (sin theta)))))
  (- (L (up t (up theta 'phi) (up thetadot phidot)))
     (* p phidot)))

;; It rests at alpha if p² has the right value: the one of phidot² = g/(l cos alpha).
(define (p-cone alpha)
  (* 'm (square 'l) (square (sin alpha)) (sqrt (/ 'g (* 'l (cos alpha))))))
(verify-equilibrium (L-reduced (p-cone 'alpha)) 'alpha)
(small-oscillation-frequencies (L-reduced (p-cone 'alpha)) 'alpha)

;; A plausible attempt: the speed at which a pendulum of that length swings.
(define (p-attempt alpha) (* 'm (square 'l) (square (sin alpha)) (sqrt (/ 'g 'l))))
(verdict-status (verify-equilibrium (L-reduced (p-attempt 'alpha)) 'alpha))

(module+ test
  (require rackunit)
  (test-case "the cone is an equilibrium of the reduced system, the attempt is not"
    (check-pred proved? (verify-equilibrium (L-reduced (p-cone 'alpha)) 'alpha))
    (check-pred refuted? (verify-equilibrium (L-reduced (p-attempt 'alpha)) 'alpha)))
  (test-case "ω² = (g/l cos α)(1 + 3 cos² α)"
    (define omega (car (small-oscillation-frequencies (L-reduced (p-cone 'alpha)) 'alpha)))
    (check-pred proved?
                (verify-equal (square omega)
                              (* (/ 'g (* 'l (cos 'alpha))) (+ 1 (* 3 (square (cos 'alpha)))))))))
