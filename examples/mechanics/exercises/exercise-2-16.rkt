#lang mechanics
;; Exercise 2.16 (SICM 2.10): precession of the top
;; Checked: the rate at which a top goes round at a constant tilt
;; How: the Lagrange equation of θ, Newton's rule, and a motion

;; At which rates φ̇ does a top with the spin ω along its axis keep the tilt θ?  What is left of
;; them when ω is large, and does it agree with torque = change of angular momentum?

(define ((V gMR) (up t (up theta phi psi) v)) (* gMR (cos theta)))
(define (L-top A C gMR) (- (T-body-Euler A A C) (V gMR)))

;; A motion at a constant tilt; the spin along the axis is ψ̇ + φ̇ cos θ.
(define (steady t)
  (up 'theta (* 'Omega t) (* (- 'omega (* 'Omega (cos 'theta))) t)))
(define residual (((Lagrange-equations (L-top 'A 'C 'gMR)) steady) 't))
residual

(define condition
  (+ (* 'A (cos 'theta) (square 'Omega)) (* -1 'C 'omega 'Omega) 'gMR))
(define right (verify-equal (ref residual 0) (* -1 (sin 'theta) condition)))
right

;; Its roots are those of the library.
(define slow (car (steady-precessions 'A 'C 'gMR 'theta 'omega)))
(define root (prove-zero (substitute condition 'Omega slow)))
root

;; Newton: the angular momentum C ω along the axis turns at the rate Ω, C ω Ω sin θ = gMR sin θ.
(define newton (/ 'gMR (* 'C 'omega)))
(define wrong (prove-zero (substitute condition 'Omega newton)))
(verdict-residual wrong)

;; The residual vanishes with 1/ω²: it is the limit of a large spin.  With numbers,
(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define (ratio spin)
  (/ (car (steady-precessions A C gMR 0.4 spin)) (/ gMR (* C spin))))
(map ratio '(200 1000 10000))

;; and a motion keeps its tilt.
(define rate (car (steady-precessions A C gMR 0.4 200)))
(define start (up 0 (up 0.4 0 0) (up 0 rate (- 200 (* rate (cos 0.4))))))
(define advance (state-advancer (compose Lagrangian->state-derivative L-top) A C gMR))
(define later (advance start 2 1e-12))
(< (abs (- (ref later 1 0) 0.4)) 1e-9)
(< (abs (- (ref later 1 1) (* 2 rate))) 1e-9)

(module+ test
  (require rackunit)
  (test-case "the condition, and its root"
    (check-pred proved? right)
    (check-pred proved? root))
  (test-case "Newton's rule is the limit of a large spin"
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal (verdict-residual wrong)
                                      (* 'A (cos 'theta) (square newton))))
    (check-= (ratio 200) 1.132 1e-3)
    (check-= (ratio 10000) 1 1e-4))
  (test-case "a top that goes round steadily"
    (check-= (ref later 1 0) 0.4 1e-9)
    (check-= (ref later 1 1) (* 2 rate) 1e-9)))
