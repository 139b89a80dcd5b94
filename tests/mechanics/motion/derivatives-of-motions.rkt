#lang racket/base
;; Derivatives of where a motion leads: by its start, by the duration, of any order.

(require mechanics mechanics/book mechanics/scmutils
         "../support/checks.rkt" "../support/close.rkt")

(define pendulum (Lagrangian->state-derivative (L-pendulum 1 1 1)))
(define (swung x [t 2]) ((state-advancer pendulum) (up 0 x 0.3) t 1e-13))
(define (angle x) (coordinate (swung x)))
(define (angle-after x t) (coordinate (swung x t)))
(define (by-differences f) (richardson-derivative f 1e-9))

(test-case "by the start: as differences give it, and to rounding"
  (check-close ((D angle) 1.0) ((by-differences angle) 1.0) 1e-9)
  ;; an oscillator is linear
  (define advance (state-advancer (Lagrangian->state-derivative (L-harmonic 1 4))))
  (define slopes ((D (lambda (s) (advance s 0.5 1e-14))) (up 0 0.3 0.7)))
  (check-close (ref slopes 1) (up 0 (cos 1) (* -2 (sin 1))) 1e-13)
  (check-close (ref slopes 2) (up 0 (* 1/2 (sin 1)) (cos 1)) 1e-13))

(test-case "derivatives of a flow that keeps areas have the determinant 1"
  (define H (Lagrangian->Hamiltonian (L-pendulum 1 1 1)))
  (define advance (state-advancer (Hamiltonian->state-derivative H)))
  (define (end q p) (state->qp (advance (up 0 q p) 3 1e-13)))
  (define (state->qp s) (up (coordinate s) (momentum s)))
  (define J (list ((D (lambda (q) (end q 0.5))) 1.0) ((D (lambda (p) (end 1.0 p))) 0.5)))
  (check-close (- (* (ref (car J) 0) (ref (cadr J) 1)) (* (ref (car J) 1) (ref (cadr J) 0)))
               1.0 1e-12))

(test-case "of higher order, and derivatives within derivatives"
  (define second ((by-differences (D angle)) 1.0))
  (check-close (((expt D 2) angle) 1.0) second 1e-9)
  (check-close ((D (lambda (x) ((D angle) x))) 1.0) second 1e-9)
  (check-close (((expt D 3) angle) 1.0) ((by-differences ((expt D 2) angle)) 1.0) 1e-8))

(test-case "by the duration: the state derivative where the motion is"
  (check-close ((D (lambda (t) (swung 1.0 t))) 2.0) (pendulum (swung 1.0 2.0)) 1e-13)
  (check-close ((D (lambda (a) (angle-after (* a 1.0) (* a 2.0)))) 1.0)
               ((by-differences (lambda (a) (angle-after (* a 1.0) (* a 2.0)))) 1.0)
               1e-9))

(test-case "what receives the state receives the one that varies"
  (define (f x) ((state-advancer pendulum) (up 0 x 0.3) 2 1e-13 (lambda (s t h) (coordinate s))))
  (check-close ((D f) 1.0) ((D angle) 1.0) 1e-12))

(test-case "second derivatives by the duration: how the rate changes along the motion"
  (define after-2 (swung 1.0 2.0))
  (check-close (((expt D 2) (lambda (t) (swung 1.0 t))) 2.0)
               (* ((D pendulum) after-2) (pendulum after-2))
               1e-12))

(test-case "an angle brought back by a turn is differentiable where that happens"
  (check-equal? ((D (principal-value :pi)) :pi) 1)
  (check-close (((expt D 2) (compose sin (principal-value :pi))) 9.0) (- (sin 9.0)) 1e-14))

;; x = a cos √k t, so that ∂²x/∂a∂k = −t sin(√k t)/(2 √k).
(test-case "by the start and by a parameter, in either order"
  (define (spring k) (lambda (s) (up 1 (ref s 2) (* -1 k (ref s 1)))))
  (define (end a k) (coordinate ((state-advancer spring k) (up 0 a 0) 3 1e-12)))
  (define expected (/ (* -3 (sin 6.0)) 4))
  (check-= ((D (lambda (k) ((D (lambda (a) (end a k))) 1.0))) 4.0) expected 1e-9)
  (check-= ((D (lambda (a) ((D (lambda (k) (end a k))) 4.0))) 1.0) expected 1e-9))
