#lang racket/base
;; Actions and frequencies of orbits below 1e-13 were wrong without a word, as 15 times too large
;; and negative: integration takes 1 for the size of things.

(require mechanics "../support/checks.rkt")

(define ((oscillator m k) (up t q p)) (+ (/ (square p) (* 2 m)) (* 1/2 k (square q))))
(define (pendulum (up t q p)) (- (/ (square p) 2) (cos q)))

(define sizes '(1e-3 1e-6 1e-13 1e-15 1e-18 1e-40))

(test-case "an oscillator: J = E/ω at any size, from rest and from the middle"
  (for* ([a sizes] [m '(1 1e-26)] [k '(1 100.0)])
    (define H (oscillator m k))
    (define omega (sqrt (/ k m)))
    (define J (* 1/2 (sqrt (* k m)) a a))
    (for ([s (list (up 0 a 0) (up 0 0 (* (sqrt (* k m)) a)))])
      (check-= (/ (frequency-of-orbit H s) omega) 1 1e-9)
      (check-= (/ (action-of-orbit H s) J) 1 1e-8))))

(test-case "a pendulum of small swings, its angle and back"
  (for ([a (cdr sizes)])
    (check-= (frequency-of-orbit pendulum (up 0 a 0)) 1 1e-9)
    (check-= (/ (action-of-orbit pendulum (up 0 0 a)) (* 1/2 a a)) 1 1e-8)
    (define at ((state->action-angle pendulum) (up 0 a a)))
    (check-= (coordinate at) (/ pi 4) 1e-8)
    (check-= (/ (momentum at) (* a a)) 1 1e-8)
    (define back ((action-angle->state pendulum) at))
    (check-= (/ (coordinate back) a) 1 1e-6)
    (check-= (/ (momentum back) a) 1 1e-6)))
