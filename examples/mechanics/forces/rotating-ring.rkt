#lang mechanics
;; A bead on a ring that rotates about its vertical diameter.
;;
;; The angle θ of the bead is measured from the bottom.  When the ring is fast enough the
;; bottom is no longer a place to rest, and two others appear beside it.

(define ((on-ring R omega c) t theta)
  (define phi (+ (* omega t) c))
  (up (* R (sin theta) (cos phi))
      (* R (sin theta) (sin phi))
      (* -1 R (cos theta))))
(define ((weight m g) t r v) (up 0 0 (* -1 m g)))

(define T (kinetic-energy 'm (on-ring 'R 'omega 'c)))
(T (up 't 'theta 'thetadot))

;; Newton's equations along the ring are Lagrange's.
(define theta (literal-function 'theta))
(define newton ((d-Alembert-equations 'm (on-ring 'R 'omega 'c) (weight 'm 'g)) theta))
(define ((L-ring m R omega g) (up t theta thetadot))
  (+ (* 1/2 m (square R) (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))
(define L (L-ring 'm 'R 'omega 'g))
(verify-equal newton ((Lagrange-equations L) theta))
(newton 't)

;; Equilibria are where no force remains: where sin θ = 0, at the bottom and at the top, and
;; where cos θ = g/(R ω²), if that is less than 1.
(define (force-at theta) (((partial 1) L) (up 't theta 0)))
(force-at 'theta)
(define aside (acos (/ 'g (* 'R (square 'omega)))))
(prove-zero (force-at aside))

;; Frequencies of small oscillations about each.  That at the top is never real; of the
;; others one is when the other is not, so they exchange stability at ω² = g/R.
(small-oscillation-frequencies L 0)
(small-oscillation-frequencies L ':pi)
(small-oscillation-frequencies L aside)

;; In numbers, with R = 1 and g = 9.8, the bead is let go from rest.
(define (bead omega start)
  (evolve-trajectory (Lagrangian->state-derivative (L-ring 1.0 1.0 omega 9.8))
                     (up 0.0 start 0.0) 10.0 #:tolerance 1e-12
                     #:events (event velocity #:name 'turns-back)))
(define (turns tr) (map occurrence-time (trajectory-events tr)))
(define (angles tr)
  (for/list ([e (trajectory-events tr)]) (coordinate (occurrence-state e))))
(define (period-of tr) (- (caddr (turns tr)) (car (turns tr))))
(define (period-from frequency omega)
  (/ :2pi (substitute (car frequency) 'R 1.0 'g 9.8 'omega omega)))

;; Below, ω = 2: it swings through the bottom, in the time that the frequency says.
(define slow (bead 2.0 0.01))
(list (period-of slow) (period-from (small-oscillation-frequencies L 0) 2.0))
;; Above, ω = 4: it leaves the bottom, goes far aside, and comes back to where it was.
(define fast (bead 4.0 0.01))
(angles fast)
;; But near its new place it swings as that frequency says.
(define near (bead 4.0 (+ 0.01 (acos (/ 9.8 16.0)))))
(list (period-of near) (period-from (small-oscillation-frequencies L aside) 4.0))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-same a b) (check-true (proved? (verify-equal a b))))
  (test-case "the kinetic energy"
    (check-same (T (up 't 'theta 'thetadot))
                (* 1/2 'm (square 'R)
                   (+ (square 'thetadot) (square (* 'omega (sin 'theta)))))))
  (test-case "the residual, from Newton and from Lagrange"
    (define expected
      (+ (* 'm (square 'R) (((expt D 2) theta) 't))
         (* -1 'm (square 'R) (square 'omega) (sin (theta 't)) (cos (theta 't)))
         (* 'm 'g 'R (sin (theta 't)))))
    (check-same (newton 't) expected)
    (check-same (((Lagrange-equations L) theta) 't) expected))
  (test-case "the place beside the bottom is an equilibrium, and another angle is not"
    (check-true (proved? (prove-zero (force-at aside))))
    (check-true (refuted? (prove-zero (force-at (* 2 aside))))))
  (test-case "the squares of the frequencies"
    (define (squared q) (square (car (small-oscillation-frequencies L q))))
    (check-same (squared 0) (- (/ 'g 'R) (square 'omega)))
    (check-same (squared ':pi) (- (+ (/ 'g 'R) (square 'omega))))
    (check-same (squared aside)
                (- (square 'omega) (square (/ 'g (* 'R 'omega))))))
  (test-case "periods of small oscillations, on both sides"
    (check-= (period-of slow) (period-from (small-oscillation-frequencies L 0) 2.0) 1e-3)
    (check-= (period-of near) (period-from (small-oscillation-frequencies L aside) 4.0) 1e-3))
  (test-case "below, the bead never goes farther than it started"
    (for ([a (angles slow)]) (check-= (abs a) 0.01 1e-10)))
  (test-case "above, it turns back where the cosines of both ends add up to 2g/(R ω²)"
    (check-= (+ (cos 0.01) (cos (car (angles fast)))) (/ (* 2 9.8) 16.0) 1e-9)
    (check-= (cadr (angles fast)) 0.01 1e-9))
  (test-case "the energy on the rotating ring is kept, though the ring is driven"
    (define E (Lagrangian->energy (L-ring 1.0 1.0 4.0 9.8)))
    (for ([s (trajectory-states fast)])
      (check-= (E s) (E (up 0.0 0.01 0.0)) 1e-10))))
