#lang mechanics
;; Exercise 6.9 (SICM 6.4): the Lagrangian analog
;; Checked: the rate of a function of (t, q, v) along motions, and what it is good for
;; How: along a motion in closed form, conserved quantities, a series for the motion

;; D_L F = ∂₀F + ∂₁F v + ∂₂F a, with the acceleration a(t, q, v) of Lagrange's equations: unlike the
;; total time derivative D_t it gives a function of the same state.
(define (D-L L)
  (define rate (Lagrangian->state-derivative L))
  (lambda (F) (lambda (s) (* ((D F) s) (rate s)))))

(define ((L-oscillator m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define L (L-oscillator 'm 'k))
(define state (up 't 'q 'v))

(define omega (sqrt (/ 'k 'm)))
(define (x t) (* 'a (cos (* omega t))))
(define F (literal-function 'F (Lagrangian 1)))
(define along
  (assuming ('(> m 0) '(> k 0))
    (verify-equal ((D (compose F (Gamma x))) 't) (((D-L L) F) ((Gamma x) 't)))))
along

;; A conserved quantity has the rate 0: no motion is needed.
(define conserved (prove-zero (((D-L L) (Lagrangian->energy L)) state)))
conserved

;; Its exponential moves q on: a series for the motion of a pendulum.
(define ((L-pendulum g) (up t theta rate)) (+ (* 1/2 (square rate)) (* g (cos theta))))
(define D-pendulum (D-L (L-pendulum 9.8)))
(define start (up 0. 1. 0.5))
(define (advanced dt n)
  (for/fold ([sum 0] [F coordinate] #:result sum) ([k (+ n 1)])
    (values (+ sum (* (/ (expt dt k) (factorial k)) (F start))) (D-pendulum F))))
(define integrated
  (coordinate ((state-advancer Lagrangian->state-derivative (L-pendulum 9.8)) start 0.1 1e-13)))
(list (advanced 0.1 5) integrated)

;; The slip: the acceleration left out.
(define ((slip-D-L F) (up t q v)) (* ((D F) (up t q v)) (up 1 v 0)))
(define slip (prove-zero ((slip-D-L (Lagrangian->energy L)) state)))
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "along a motion, and of what is conserved"
    (check-pred proved? along)
    (check-pred proved? conserved)
    (check-pred refuted? slip))
  (test-case "the series of the motion"
    (check-= (advanced 0.1 5) integrated 1e-5)
    (check-true (< (abs (- (advanced 0.1 5) integrated))
                   (* 0.1 (abs (- (advanced 0.1 3) integrated)))))))
