#lang mechanics
;; Exercise 5.3 (SICM 5.2): no Lagrangian for ωI
;; Checked: that the velocity does not determine the momentum
;; How: the second derivative that a Legendre transform divides by, for any H

;; An oscillator in its polar-canonical coordinates has H' = ω I. Has it a Lagrangian?

(define H (compose (lambda (s) (+ (/ (square (momentum s)) (* 2 'm))
                                  (* 1/2 'k (square (coordinate s)))))
                   (polar-canonical (sqrt (* 'k 'm)))))
(define state (up 't 'theta 'I))
(H state)

;; Its velocity is ω whatever the momentum is: I cannot be found from it.
(define velocity-of-angle (((partial 2) H) state))
velocity-of-angle
(define right (verify-equal (((partial 2) ((partial 2) H)) state) 0))
right

;; Another α leaves the angle in H', but the momentum alone as a factor: no Lagrangian, either.
(define H-alpha (compose (lambda (s) (+ (/ (square (momentum s)) (* 2 'm))
                                        (* 1/2 'k (square (coordinate s)))))
                         (polar-canonical 'alpha)))
(define any-alpha (verify-equal (((partial 2) ((partial 2) H-alpha)) state) 0))

;; The slip: L = p v − H with p kept, which is p (v − ω), no function of the velocity alone.
(define slip (verify-equal (- (* 'I 'v) (H state)) 0))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the velocity is the same for all momenta"
    (check-pred proved? right)
    (check-pred proved? any-alpha)
    (check-pred proved? (verify-equal velocity-of-angle (sqrt (/ 'k 'm)))))
  (test-case "what is left of p v − H vanishes on the motion alone"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (- (* 'I velocity-of-angle) (H state)) 0))))
