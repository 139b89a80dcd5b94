#lang racket/base
;; Long runs in numbers of higher precision: the motions of SICM 1.7 and 2.8 to all known
;; digits, and what flonums are worth.

(require mechanics
         (only-in mechanics/book pend-state-derivative)
         "../support/checks.rkt"
         "../support/bigfloats.rkt" "../support/close.rkt" "../support/skip.rkt"
         "../support/systems.rkt")

;; ---------------------------------------------------------------------------
;; Systems

;; A free rigid body in Euler's angles.
(define ((L-rigid A B C) (up t (up θ φ ψ) (up θ* φ* ψ*)))
  (define a (+ (* φ* (sin θ) (sin ψ)) (* θ* (cos ψ))))
  (define b (- (* φ* (sin θ) (cos ψ)) (* θ* (sin ψ))))
  (define c (+ (* φ* (cos θ)) ψ*))
  (* 1/2 (+ (* A (square a)) (* B (square b)) (* C (square c)))))

;; ---------------------------------------------------------------------------

(skip-unless bigfloats? no-bigfloats
  (test-case "the driven pendulum, to all printed digits (p. 76)"
    (define ω (* 2 (sqrt (bigfloat 98/10 200))))
    (define advance (state-advancer pend-state-derivative 1 1 98/10 1/10 ω))
    (check-close (advance (up 0 1 0) 1 1e-25 #:precision 100)
                 '(1 #e-1.03011568739188687 #e-1.40985359335821735) 5e-18)
    (check-close (advance (up 0 1 0) 10 1e-25 #:precision 100)
                 '(10 #e1.27379225442614696 #e-3.45379718978431025) 5e-18))

  (test-case "when a run of the driven pendulum in flonums is no longer to be believed"
    (define ω (* 2 (sqrt (bigfloat 98/10 200))))
    (define flonums
      (evolve-trajectory (pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8))) (up 0 1 0) 100
                         #:tolerance 1e-13))
    (define wrong
      (let/ec return
        ((evolve pend-state-derivative 1 1 98/10 1/10 ω) (up 0 1 0)
         (lambda (s)
           (when (> (abs (- (coordinate s) (coordinate (flonums (time s))))) 0.1)
             (return (exact->inexact (time s)))))
         2 100 1e-16 #:precision 70)
        #f))
    (check-true (and wrong (< 60 wrong 100)) (format "~a" wrong)))

  (test-case "the double pendulum (exercise 1.44)"
    (define advance
      (state-advancer (lambda parameters
                        (Lagrangian->state-derivative (apply L-double-pendulum parameters)))
                      1 3 1 9/10 98/10))
    (define π (acos (bigfloat -1 200)))
    (define s1 (advance (up 0 (up (/ π 2) π) (up 0 0)) 1 1e-18 #:precision 72))
    (check-close s1
                 '(1 #e.0910630038849611 #e-1.66626245247204
                     #e-5.1832373624753 #e-4.02581660181084)
                 5e-14)
    (check-close (advance s1 4 1e-17 #:precision 72)
                 '(5 #e6.82360398985888 #e8.60368993913788 #e-3.01497306538466 #e3.79006470284155)
                 1e-14))

  (test-case "the free rigid body after t = 100 (p. 145)"
    (define L (L-rigid 1 (sqrt (bigfloat 2 100)) 2))
    (check-close
     ((state-advancer (lambda () (Lagrangian->state-derivative L)))
      (up 0 (up 1 0 0) (up 1/10 1/10 1/10)) 100 1e-15 #:precision 64)
     '(100 #e.6319896958326486 #e1.361027154088125 #e17.43790048473838
           #e-.1234371619718829 #e.09016109524795829 #e.07567921658610047)
     5e-15)))
