#lang mechanics
;; Exercise 4.1 (SICM 4.2.1): the equilibria of the pendulum
;; Checked: the exponents at both, the frequency, and the directions against contours of H
;; How: with symbols, by D of the state derivative; the energy along the directions

(require mechanics/book)

(define H (Lagrangian->Hamiltonian (L-pendulum 'g 'm 'l)))
(define rates (Hamiltonian->state-derivative H))

;; The rates of θ and p by θ and p, near (θ, 0): 0, 1/(m l²) and −g m l cos θ, 0.
(define (slope theta)
  (define J ((D rates) (up 't theta 0)))
  (matrix-by-rows (list (ref J 1 1) (ref J 2 1)) (list (ref J 1 2) (ref J 2 2))))
(simplify (slope 0))
(simplify (slope :pi))

;; An attempt: λ² = −(g/l) cos θ.  So ±i √(g/l) at the bottom, oscillations of the frequency
;; √(g/l), and ±√(g/l) at the top.  The slip forgets the root.
(define (characteristic theta lambda)
  (define M (slope theta))
  (determinant (matrix-by-rows (list (- (ref M 0 0) lambda) (ref M 0 1))
                               (list (ref M 1 0) (- (ref M 1 1) lambda)))))
(define omega (sqrt (/ 'g 'l)))
(define bottom (verify-equal (characteristic 0 (* +i omega)) 0))
(define top (verify-equal (characteristic :pi omega) 0))
(define slip (verify-equal (characteristic :pi (/ 'g 'l)) 0))
(list bottom top)

;; The directions at the top, (1, ±m l² √(g/l)): along them the energy of second order is 0, as
;; along the contour through the point, the separatrix.
(define (second-order theta dtheta dp)
  (((expt D 2) (lambda (s) (H (up 't (+ theta (* s dtheta)) (* s dp))))) 0))
(define along (verify-equal (second-order :pi 1 (* 'm (square 'l) omega)) 0))
along

;; At the bottom they are complex; the real combinations go round an ellipse, a contour of H:
;; θ = a cos ωt, p = −a m l² ω sin ωt have one energy of second order.
(define (energy-at phase)
  (second-order 0 (cos phase) (* -1 'm (square 'l) omega (sin phase))))
(define on-contour (verify-equal (energy-at 'phi) (energy-at 0)))
on-contour

(module+ test
  (require rackunit)
  (test-case "the exponents"
    (check-pred proved? bottom)
    (check-pred proved? top)
    (check-pred refuted? slip))
  (test-case "the directions, and contours of the Hamiltonian"
    (check-pred proved? along)
    (check-pred proved? on-contour)
    (check-pred refuted? (verify-equal (second-order :pi 1 0) 0))))
