#lang racket/base
;; Actions and angles by integration, against closed forms.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt"
         "../support/notes.rkt")

(define ((oscillator m k) (up t q p)) (+ (/ (square p) (* 2 m)) (* 1/2 k (square q))))

(test-case "the oscillator: I = E/ω"
  (define H (oscillator 2.0 8.0))
  (define state (up 0 1.0 3.0))
  (check-close (action-of-orbit H state) (/ (H state) 2.0) 1e-9)
  (check-close (frequency-of-orbit H state) 2.0 1e-9)
  ;; its angle is that of polar-canonical
  (check-close ((state->action-angle H) state) ((polar-canonical-inverse 4.0) state) 1e-8)
  (for ([angle '(0.4 6.1 -1.0 14.0)])
    (check-close ((action-angle->state H) (up 0 angle 3.0))
                 ((polar-canonical 4.0) (up 0 angle 3.0))
                 1e-8)))

(test-case "the pendulum, swinging and turning"
  (define H (Hpendulum 1 9.8))
  (define swing (up 0 0.7 1.5))
  (check-close (action-of-orbit H swing) (pendulum-oscillating-action 1 9.8 (H swing)) 1e-9)
  (check-close (frequency-of-orbit H swing) (pendulum-frequency 1 9.8 (H swing)) 1e-9)
  (check-close (coordinate ((state->action-angle H) swing))
               ((pendulum-oscillating-phase 1 9.8) swing) 1e-8)
  (define turn (up 0 0.7 9.0))
  (check-close (action-of-orbit H turn #:turn (* 2 pi))
               (pendulum-circulating-action 1 9.8 (H turn)) 1e-8)
  (check-close (frequency-of-orbit H turn #:turn (* 2 pi))
               (pendulum-frequency 1 9.8 (H turn))
               1e-9))

;; Kepler's radial motion: I_r = −L + m μ/√(−2 m E)
(test-case "the radial action of Kepler's problem"
  (define ((radial m mu L) (up t r p))
    (+ (/ (square p) (* 2 m)) (/ (square L) (* 2 m (square r))) (/ (* -1 mu) r)))
  (define H (radial 1.0 1.0 0.8))
  (define state (up 0 1.0 0.1))
  (define E (H state))
  (check-close (action-of-orbit H state) (- (/ 1 (sqrt (* -2 E))) 0.8) 1e-8)
  ;; the period of the orbit, by the third law
  (check-close (frequency-of-orbit H state) (expt (* -2 E) 3/2) 1e-8))

(test-case "there and back"
  (define (H s) (+ (/ (square (momentum s)) 2) (/ (expt (coordinate s) 4) 4)))
  (define state (up 0 0.5 -0.3))
  (check-close ((action-angle->state H) ((state->action-angle H) state)) state 1e-7))

(says
 [(action-of-orbit (oscillator 1 1) (up 0 0 0))
  "action-of-orbit: a state at rest has no period; given (up 0 0 0)"]
 [(action-of-orbit (oscillator 1 1) (up 0 'q 0))
  "action-of-orbit: expected a state of one coordinate, in numbers; given (up 0 q 0)"]
 [((state->action-angle (oscillator 1 1) #:center 9) (up 0 1 0))
  "state->action-angle: the motion through (up 0 1 0) does not pass the coordinate 9 forwards; "
  "#:center names one"]
 [(state->action-angle 3)
  "state->action-angle: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [(action-angle->state 3)
  "action-angle->state: a Hamiltonian is a function of the state (up t q p); given the number 3"]
 [((action-angle->state (oscillator 1 1)) (up 0 1 -1))
  "action-angle->state: expected an angle and a positive action, in numbers; given (up 0 1 -1)"])

;; I = d²/2 from the distance d of the place of rest
(test-case "a small orbit keeps its digits, on whichever side of the start it turns about"
  (for ([rest '(1e-8 -1e-8)])
    (define (H s) (* 1/2 (+ (square (momentum s)) (square (- (coordinate s) rest)))))
    (define start (up 0 1e-200 0.0))
    (check-close (/ (action-of-orbit H start) (* 1/2 (square rest))) 1 1e-9)
    (check-close (frequency-of-orbit H start) 1 1e-9)))

(test-case "a motion that does not close"
  (check-message
   "action-of-orbit: the motion through (up 0 0 1) did not close by the time 10"
   (action-of-orbit (lambda (s) (square (momentum s))) (up 0 0 1) #:longest-time 10)
   exn:fail:mechanics:not-convergent?)
  (define (hill s) (- (* 1/2 (square (momentum s))) (expt (coordinate s) 4)))
  (check-regexp-match
   #rx"^action-of-orbit: the motion through .* does not close: .* too short to change the time$"
   (message-of (action-of-orbit hill (up 0 1.0 1.0)) exn:fail:mechanics:not-convergent?)))

;; ---------------------------------------------------------------------------
;; Centers, turns and separatrices

(define unit-pendulum (Hpendulum 1 1))

(test-case "a turn does not move the angle of a swing"
  (for ([state (list (up 0 0 -1.85) (up 0 0.3 1.8) (up 0 -2.0 0.5) (up 0 1.8 0.5))])
    (check-close ((state->action-angle unit-pendulum #:center 1.5 #:turn (* 2 pi)) state)
                 ((state->action-angle unit-pendulum #:center 1.5) state)
                 1e-7)))

(test-case "close to the separatrix, where larger momenta turn"
  (define found ((action-angle->state unit-pendulum) (up 0 0 2.2)))
  (check-close (pendulum-oscillating-action 1 1 (unit-pendulum found)) 2.2 1e-8)
  ;; at the angle 0 it passes the center, rising
  (check-= (coordinate found) 0 1e-12)
  (check-true (> (momentum found) 1.9)))

(test-case "a turning motion, there and back"
  (define state (up 0 1.0 3.0))
  (define there ((state->action-angle unit-pendulum #:turn (* 2 pi)) state))
  (check-close ((action-angle->state unit-pendulum #:turn (* 2 pi)) there) state 1e-7))

;; At rest everywhere when the time is 0, or, with the energy of an oscillator, at the origin
(define ((growing oscillating) s)
  (+ (* (time s) (momentum s)) (* oscillating ((oscillator 1 1) s))))

;; The same where the coordinate is the momentum
(define (sheared s) (* (time s) (momentum s) (- (coordinate s) (momentum s))))

(says
 [((state->action-angle unit-pendulum #:turn (* 2 pi)) (up 0 1 -3))
  "state->action-angle: the motion through (up 0 1 -3) turns backwards, and has no positive "
  "action; mirror the coordinate and the momentum"]
 [((action-angle->state (oscillator 1 1) #:center 1) (up 0 1 0.3))
  "action-angle->state: no motion that closes and passes the coordinate 1 was found with the "
  "action 0.3; #:center names another"]
 [(action-of-orbit (lambda (s) (+ (square (momentum s)) (* (square (coordinate s)) (cos (time s)))))
                   (up 0 1 0))
  "action-of-orbit: <function> depends on the time, and its motions have no action"]
 [(action-of-orbit (growing 0) (up 0 1 1))
  "action-of-orbit: growing depends on the time, and its motions have no action"]
 [((action-angle->state (growing 0)) (up 0 0.3 1))
  "action-angle->state: growing depends on the time, and its motions have no action"]
 [((action-angle->state sheared) (up 0 0.3 1))
  "action-angle->state: sheared depends on the time, and its motions have no action"]
 [((action-angle->state (growing 1)) (up 0 0.3 1))
  "action-angle->state: growing depends on the time, and its motions have no action"])

;; H is known to a rounding; of the energy's distance from the separatrix that is a greater part.
(test-case "next to a separatrix the frequency keeps its digits, or a note tells"
  (define (start E) (up 0 0.0 (sqrt (* 2 (+ E 1)))))
  (define (frequency E) (frequency-of-orbit (Hpendulum 1.0 1.0) (start E) #:turn (* 2 pi)))
  (define (check-frequency E tolerance)
    (check-= (/ (frequency E) (pendulum-frequency 1.0 1.0 E)) 1 tolerance (format "~a" E)))
  (for* ([side '(-1 1)] [distance '(1e-1 1e-3 1e-5 1e-7)])
    (check-equal? (told (check-frequency (+ 1 (* side distance)) 1e-9)) ""))
  (for ([side '(-1 1)])
    (define text (told (check-frequency (+ 1 (* side 1e-11)) 1e-5)))
    (check-true
     (regexp-match?
      (string-append "^; frequency-of-orbit: roundings leave fewer than half of the digits, "
                     "for the motion nearly comes\n;   to rest on its way, as next to a separatrix; about "
                     "1e-[5-8] of the frequency is uncertain\n$")
      text)
     text)))

(test-case "a Hamiltonian that has its value again at one place a turn on is not periodic"
  (define (once-again s) (+ (* 1/2 (square (momentum s)))
                            (* (coordinate s) (- (coordinate s) (* 2 pi)))))
  (check-exn #rx"^action-of-orbit: .*does not come again after a turn of 6.28"
             (lambda () (action-of-orbit once-again (up 0 0.0 1.0) #:turn (* 2 pi)))))
