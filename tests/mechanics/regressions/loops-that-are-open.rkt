#lang racket/base
;; A turn after which the Hamiltonian is another, as 360 in degrees, gave a frequency that was
;; none; and an open curve an integral invariant.

(require (except-in mechanics time)
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define pendulum (Hpendulum 1 9.8))

(says
 [(frequency-of-orbit pendulum (up 0 0 9) #:turn 360)
  "frequency-of-orbit: the coordinate of (Hpendulum 1 9.8) does not come again after a turn of 360: "
  "its value is another there\n  after (* 2 pi) it does"]
 [(action-of-orbit (lambda (s) (+ (square (momentum s)) (square (coordinate s)))) (up 0 1 0)
                   #:turn 2)
  "action-of-orbit: the coordinate of <function> does not come again after a turn of 2: "
  "its value is another there"]
 [((state->action-angle pendulum #:turn 180) (up 0 0 9))
  "state->action-angle: the coordinate of (Hpendulum 1 9.8) does not come again after a turn of "
  "180: its value is another there\n  after (* 2 pi) it does"]
 [(action-of-orbit pendulum (up 0 +nan.0 0))
  "action-of-orbit: expected a state of one coordinate, in finite numbers; given (up 0 +nan.0 0)"]
 [(loop-integral (lambda (x) (up 0 (cos x) (sin x))) 0 1)
  "loop-integral: the curve is not closed: its momenta are others at its end\n"
  "  0: (up 0 1 0)\n  1: (up 0 0.5403023058681398 0.8414709848078965)\n"
  "  once round is from 0 to (* 2 pi) where the curve is of sines and cosines"])

;; The period of the pendulum that turns is 4 K(k)/p, with k² = 4 β/p² and p at the bottom.
(test-case "in radians, or in turns of another length"
  (define k (sqrt (/ (* 4 9.8) (square 9))))
  (define period (* 4/9 (first-elliptic-integral k)))
  (check-close (frequency-of-orbit pendulum (up 0 0 9) #:turn (* 2 pi)) (/ (* 2 pi) period) 1e-7)
  (define (in-degrees (up t q p))
    (pendulum (up t (* q (/ pi 180)) (* p (/ 180 pi)))))
  (check-close (frequency-of-orbit in-degrees (up 0 0 (* 9 (/ pi 180))) #:turn 360)
               (/ (* 2 pi) period) 1e-7))

(test-case "what goes round and was not said to"
  (check-message
   (string-append "frequency-of-orbit: the motion through (up 0 0 9) did not close by the time 10"
                  "\n  it goes round; #:turn (* 2 pi) says that its coordinate comes again after a "
                  "turn")
   (frequency-of-orbit pendulum (up 0 0 9) #:longest-time 10)
   exn:fail:mechanics:not-convergent?))

(test-case "what runs away is told by its own state"
  (define message
    (message-of (action-of-orbit (lambda (s) (- (square (momentum s)) (square (coordinate s))))
                                 (up 0 1 0))
                exn:fail:mechanics:not-convergent?))
  (check-regexp-match #rx"does not close: the motion cannot be followed any further\n  time:"
                      message)
  (check-false (regexp-match? #rx"last state" message)))

;; ∮ p dθ of p = 2 + sin θ around the cylinder is 4π.
(test-case "a curve around the cylinder is closed"
  (check-close (loop-integral (lambda (x) (up 0 x (+ 2 (sin x)))) 0 (* 2 pi)) (* 4 pi) 1e-9))
