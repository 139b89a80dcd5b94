#lang racket/base
;; A motion to a section has no last time.  Where it was a polynomial, as one that is free or at
;; rest, or so fast that its Taylor coefficients overflow, a step of infinite length was tried
;; again and again.

(require (except-in mechanics time) mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/patience.rkt")

(define (within seconds thunk)
  (value-within seconds 1000 (lambda () (with-handlers ([exn:fail? exn-message]) (thunk)))
                (fail-check "it does not end")))

(define-check (check-says text got)
  (unless (and (string? got) (regexp-match? (regexp-quote text) got)) (fail-check)))

(define through-0 (event (lambda (s) (ref s 1))))
(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define (next f start [e through-0]) (within 60 (lambda () ((Poincare-map f e) start))))

(test-case "at rest"
  (check-says "the motion rests where it starts, and does not come to the surface"
              (next pendulum (up 0 0 0)))
  (define (of-velocity s) (up (ref s 1) 0))
  (check-says "rests where it starts" (next of-velocity (up 1 0))))

;; x = x₀ + v t is 0 at t = −x₀/v.
(test-case "free"
  (define (free s) (up 1 (ref s 2) 0))
  (for* ([x '(-1 -1e6 -1e-6)] [v '(1 1e9 1e-9)])
    (define there (next free (up 0 x v)))
    (check-true (close? (ref there 0) (- (/ x v)) 1e-12)))
  (check-says "has not come back to the surface" (next free (up 0 1 1))))

;; y = 1 + t − t²/2 is 0 at 1 + √3, and later no more.
(test-case "falling"
  (define (falling s) (up 1 (ref s 2) -1))
  (define there (next falling (up 0 1 1)))
  (check-close (ref there 0) (+ 1 (sqrt 3)) 1e-12)
  (check-says "has not come back" (next falling there)))

;; x = log(1 + t) comes to any place, in its time, for which a double has no room.
(test-case "ever more slowly"
  (define (slowing s) (up 1 (ref s 2) (* -1 (square (ref s 2)))))
  (check-says "has not come back"
              (next slowing (up 0 0 1) (event (lambda (s) (- (ref s 1) 1e6)))))
  (check-close (ref (next slowing (up 0 0 1) (event (lambda (s) (- (ref s 1) 3)))) 0)
               (- (exp 3) 1) 1e-9))

(test-case "by a method that tries its steps"
  (define (decides s) (up 1 (if (> (ref s 2) 1) 1 (ref s 2)) 0))
  (check-close (ref (next decides (up 0 -1 1/2)) 0) 2 1e-9)
  (check-says "has not come back" (next decides (up 0 1 1))))

;; The powers of a long step overflowed, and with them the terms that are 0.
(test-case "crossings within very long steps"
  (define (falling s) (up 1 (ref s 2) -1))
  (for ([end '(1e6 1e9 1e12 1e15 1e18)])
    (define motion (evolve-trajectory falling (up 0 1 1) end #:events through-0))
    (define times (map occurrence-time (trajectory-events motion)))
    (check-equal? (length times) 1)
    (check-true (close? (car times) (+ 1 (sqrt 3)) (max 1e-12 (* 1e-15 end))))))

;; Beyond the saddle of Hénon and Heiles's potential motions run away.
(test-case "running away"
  (define HH (HHmap 1/8 0.1 1e-10 1e-12))
  (check-says "the map has no image of a point that is needed"
              (within 60 (lambda () (rotation-number HH (up 5 0) 100)))))
