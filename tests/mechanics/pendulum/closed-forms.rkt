#lang racket/base
;; The pendulum in closed form: against numbers computed independently, against integration, and
;; against itself.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (frequency E) (pendulum-frequency 1 9.8 E))

(test-case "the frequency at p = 4.9006733894348145 (25 digits computed elsewhere)"
  (define E ((Hpendulum 1 9.8) (up 0 0 4.9006733894348145)))
  (check-close (frequency E) 2.5043962735932018 1e-12)
  (check-close (pendulum-oscillating-frequency 1 9.8 E) 2.5043962735932018 1e-12))

(test-case "its Fourier series"
  (define terms ((pendulum-solution-series 1 9.8) (up 0 0 4.9006733894348145)))
  (for ([term (series:head (terms 't) 3)]
        [amplitude '(1.8349993630565 .038213003445971 .0013531286425114)] [n '(1 3 5)])
    (check-close ((D (lambda (t) (series:ref (terms t) (quotient n 2)))) 0)
                 (* amplitude n 2.5043962735932018) 1e-9))
  (define angle (pendulum-oscillating-angle 1 9.8 ((Hpendulum 1 9.8) (up 0 0 4.9006733894348145))))
  (check-close (series:sum (terms 0.7) 12) (angle 0.7) 1e-12))

(test-case "the series of a pendulum that turns"
  (define state (up 0 0 8.0))
  (define angle (pendulum-circulating-angle 1 9.8 ((Hpendulum 1 9.8) state)))
  (check-close (series:sum (((pendulum-solution-series 1 9.8) state) 0.3) 20) (angle 0.3) 1e-12))

(test-case "periods at amplitudes 1, π/6 and π/2"
  (define (period theta) (/ (* 2 pi) (frequency (* -9.8 (cos theta)))))
  (check-close (period 1.0) 2.140228719018093 1e-11)
  (define small (/ (* 2 pi) (sqrt 9.8)))
  (check-close (/ (period (/ pi 6)) small) 1.017408797596 1e-11)
  (check-close (/ (period (/ pi 2)) small) 1.1803405990161 1e-11))

(define-syntax-rule (for-states (state (q p) ...) body ...)
  (for ([state (list (up 0.5 q p) ...)]) body ...))

(test-case "the state at a time, by formula and by integration"
  (for-states (state (1.0 0.5) (-0.3 -4.0) (2.0 7.0) (-1.0 -8.0) (3.0 0.1))
    (for ([t '(0.5 1.25 4.0)])
      (define a (((pendulum-advance 1 9.8) state) t))
      (define b (((pendulum-integration 1 9.8 1e-13) state) t))
      (check-close ((principal-value pi) (- (coordinate a) (coordinate b))) 0 1e-8)
      (check-close (momentum a) (momentum b) 1e-8))))

(test-case "into action and angle, and back"
  (for-states (state (1.0 0.5) (-0.3 -4.0) (2.0 -0.5))
    (check-close ((pendulum-oscillating-aa-state-to-state 2 9.8)
                  ((pendulum-oscillating-state-to-aa-state 2 9.8) state))
                 state 1e-8))
  (check-close ((pendulum-circulating-aa-state-to-state 2.0 9.8)
                ((pendulum-circulating-state-to-aa-state 2.0 9.8) (up 0.5 1.0 15.0)))
               '(0.5 1.0 15.0) 1e-8)
  (for-states (state (1.0 0.5) (-0.3 -4.0) (2.0 15.0) (-1.0 -15.0) (2.5 -14.0))
    (check-close ((pendulum-global-aa-state-to-state 2 9.8)
                  ((pendulum-state-to-global-aa-state 2 9.8) state))
                 state 1e-8)))

(test-case "the angle grows evenly along the motion, and the action rests"
  (define start (up 0 0.7 1.5))
  (define (aa t) ((pendulum-oscillating-state-to-aa-state 1 9.8)
                  (((pendulum-advance 1 9.8) start) t)))
  (define E ((Hpendulum 1 9.8) start))
  (check-close (- (coordinate (aa 0.3)) (coordinate (aa 0))) (* 0.3 (frequency E)) 1e-9)
  (check-close (momentum (aa 0.3)) (momentum (aa 0)) 1e-9))

;; dE/dI = ω
(test-case "the derivative of the energy by the action is the frequency"
  (for ([E '(-5.0 3.0 9.0)])
    (check-close ((D (lambda (E) (pendulum-oscillating-action 1 9.8 E))) E)
                 (/ 1 (frequency E)) 1e-9))
  (for ([E '(10.0 30.0)])
    (check-close ((D (lambda (E) (pendulum-circulating-action 1 9.8 E))) E)
                 (/ 1 (frequency E)) 1e-9))
  (check-close ((pendulum-oscillating-action-to-E 1 9.8) (pendulum-oscillating-action 1 9.8 2.0))
               2.0 1e-9)
  ;; from near the separatrix on
  (for ([E '(9.9 12.0 20.0 200.0)])
    (check-close ((pendulum-circulating-action-to-E 1 9.8) (pendulum-circulating-action 1 9.8 E))
                 E 1e-7)))

(test-case "areas are kept"
  (define f (pendulum-oscillating-state-to-aa-state 2.0 9.8))
  (check-close (determinant (qp-submatrix ((D-as-matrix f) (up 1.0 1.0 1.0)))) 1.0 1e-8)
  (define g (pendulum-circulating-state-to-aa-state 2.0 9.8))
  (check-close (determinant (qp-submatrix ((D-as-matrix g) (up 1.0 1.0 15.0)))) 1.0 1e-8))

(test-case "on the separatrix the actions are the limits from both sides"
  (for ([beta '(9.8 2)])
    (check-equal? (pendulum-oscillating-action 3 beta beta) (pendulum-separatrix-action 3 beta))
    (check-close (* 2 (pendulum-circulating-action 3 beta beta))
                 (pendulum-separatrix-action 3 beta)
                 1e-14)
    (check-close (pendulum-circulating-action 3 beta beta)
                 (pendulum-circulating-action 3 beta (+ beta 1e-12))
                 1e-9)))

(test-case "the separatrix"
  (define-values (angle p)
    (values (pendulum-separatrix-angle 1 9.8) (pendulum-separatrix-angular-momentum 1 9.8)))
  (check-close ((D angle) 0.4) (p 0.4) 1e-12)
  (check-close ((Hpendulum 1 9.8) (up 0 (angle 0.4) (p 0.4))) 9.8 1e-12)
  (check-close (pendulum-separatrix-action 1 9.8) (pendulum-oscillating-action 1 9.8 9.7999999999)
               1e-8)
  (check-close (inverse-gudermannian (gudermannian 0.8)) 0.8 1e-13)
  (check-identity ((D gudermannian) 'x) (/ 1 (cosh 'x))))

;; Rounding puts the sine of half of some of these angles over the modulus at 1, of others beyond.
(test-case "at the greatest angle a quarter of a swing is over, on either side"
  (define phase (pendulum-oscillating-phase 1 9.8))
  (for ([degrees (in-range 5 180 5)])
    (define angle (/ (* degrees pi) 180))
    (check-close (list (phase (up 0 angle 0)) (phase (up 0 (- angle) 0)))
                 (list (/ pi 2) (/ pi -2))
                 1e-6)))

(test-case "phases and times agree"
  (define state (up 0 0.5 1.0))
  (define E ((Hpendulum 1 9.8) state))
  (check-close ((pendulum-oscillating-angle 1 9.8 E) ((pendulum-oscillating-dt 1 9.8) state))
               0.5 1e-12)
  (check-close ((pendulum-oscillating-phase 1 9.8) state)
               (* (frequency E) ((pendulum-oscillating-dt 1 9.8) state)) 1e-12)
  (define fast (up 0 0.5 9.0))
  (define F ((Hpendulum 1 9.8) fast))
  (check-close ((pendulum-circulating-angle 1 9.8 F) ((pendulum-circulating-dt 1 9.8) fast))
               0.5 1e-12)
  (check-close ((pendulum-circulating-angular-momentum 1 9.8 F)
                ((pendulum-circulating-dt 1 9.8) fast))
               9.0 1e-12)
  (check-close ((pendulum-circulating-phase 1 9.8) fast)
               (* (frequency F) ((pendulum-circulating-dt 1 9.8) fast)) 1e-12)
  (check-close (pendulum-circulating-frequency 1 9.8 F) (frequency F) 1e-14)
  (check-close ((pendulum-oscillating-angular-momentum 1 9.8 E)
                ((pendulum-oscillating-dt 1 9.8) state))
               1.0 1e-12))

(test-case "a pendulum at rest stays where it is"
  (check-equal? (((pendulum-advance 1 9.8) (up 0 0 0)) 3) (up 3 0 0)))

(test-case "an angle is known up to whole turns"
  (for ([phase (list (pendulum-oscillating-phase 1 9.8) (pendulum-circulating-phase 1 9.8))]
        [p '(1.0 9.0)])
    (for ([turns '(-2 -1 1 3)])
      (check-close (phase (up 0 (+ 0.5 (* turns 2 pi)) p)) (phase (up 0 0.5 p)) 1e-12))))

(says
 [(pendulum-frequency 1 9.8 -10)
  "pendulum-frequency: the energy of a pendulum is at least -beta; given -10, with beta = 9.8"]
 [(pendulum-frequency 1 9.8 9.8)
  "pendulum-frequency: on the separatrix, with the energy beta, there is no period; given 9.8"]
 [(pendulum-frequency 1 9.8 'E)
  "pendulum-frequency: the energy is to be a number; given the symbol E"]
 [(pendulum-frequency 1 -1 0)
  "pendulum-frequency: beta is positive; given the number -1"]
 [((pendulum-advance -1 9.8) (up 0 0.5 1))
  "pendulum-advance: alpha is positive; given the number -1"]
 [(pendulum-oscillating-action 1 9.8 20)
  "pendulum-oscillating-action: with an energy of more than beta the pendulum turns; given 20, "
  "with beta = 9.8"]
 [(pendulum-circulating-angle 1 9.8 0)
  "pendulum-circulating-angle: with an energy of less than beta the pendulum swings; given 0, "
  "with beta = 9.8"]
 [(pendulum-circulating-angle -1 9.8 20)
  "pendulum-circulating-angle: alpha is positive; given the number -1"]
 [((pendulum-oscillating-phase 1 9.8) (up 0 0 0))
  "pendulum-oscillating-phase: a pendulum at rest has no phase"]
 [((pendulum-oscillating-state-to-aa-state 1 9.8) (up 0 0 0))
  "pendulum-oscillating-state-to-aa-state: a pendulum at rest has no phase"]
 [((pendulum-oscillating-phase 1 9.8) (up 0 1 100))
  "pendulum-oscillating-phase: with an energy of more than beta the pendulum turns; "
  "given 4994.705037402492, with beta = 9.8"]
 [((pendulum-circulating-dt 1 9.8) (up 0 1 0))
  "pendulum-circulating-dt: with an energy of less than beta the pendulum swings; "
  "given -5.29496259750777, with beta = 9.8"]
 [((pendulum-circulating-dt 1 9.8) (up 0 1 -15))
  "pendulum-circulating-dt: the pendulum turns with a negative momentum, and this is for a "
  "positive one; given (up 0 1 -15)\n  the global variables are for both: "
  "pendulum-state-to-global-aa-state"]
 [(pendulum-oscillating-frequency -1 9.8 0)
  "pendulum-oscillating-frequency: alpha is positive; given the number -1"]
 [(pendulum-frequency -1 9.8 0)
  "pendulum-frequency: alpha is positive; given the number -1"]
 [((pendulum-oscillating-action-to-E 1 1) 3)
  "pendulum-oscillating-action-to-E: the action is to be between 0 and 2.5464790894703255; given 3"]
 [((Hpendulum 1 9.8) 3)
  "Hpendulum: expected a Hamiltonian state (up t q p)\n  given: the number 3"])
