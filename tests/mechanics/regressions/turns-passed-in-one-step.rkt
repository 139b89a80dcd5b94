#lang racket/base
;; A coordinate that turns almost freely was followed in steps of many turns, and the first of
;; these at which the motion was seen to be back counted as one: actions were 67 times too great.
;; And an action had no sign, though dE/dJ is the frequency.

(require mechanics "../support/checks.rkt")

(define ((turning A) s) (- (/ (square (momentum s)) 2) (* A (cos (coordinate s)))))
(define turn (* 2 :pi))

(test-case "of free motion: p turns"
  (for* ([p '(0.01 1 2 300)] [length '(1 3 6.28)])
    (define s (up 0 1 p))
    (check-= (action-of-orbit (turning 0) s #:turn length) (/ (* p length) turn) (* p 1e-9))
    (check-= (frequency-of-orbit (turning 0) s #:turn length) (/ (* p turn) length) (* p 1e-8))))

;; J = p - A²/(4 p³) + ..., for E = p²/2 at the coordinate π/2
(test-case "of motion that is kicked a little"
  (for* ([A '(1e-8 1e-4 1e-2)] [p '(2 30)])
    (check-= (action-of-orbit (turning A) (up 0 :pi/2 p) #:turn turn)
             (- p (/ (* A A) (* 4 p p p))) 1e-8)
    (define at ((state->action-angle (turning A) #:turn turn) (up 0 :pi/2 p)))
    (check-= (coordinate at) :pi/2 (* 2 A))
    (define back ((action-angle->state (turning A) #:turn turn) at))
    (check-= (sin (- (coordinate back) :pi/2)) 0 1e-7)
    (check-= (momentum back) p 1e-7)))

;; J = -E of H = -(q² + p²)/2, J = p of H = (p + 10)²/2
(test-case "the frequency is dE/dJ, with its sign"
  (define (upside-down s) (/ (+ (square (coordinate s)) (square (momentum s))) -2))
  (check-= (action-of-orbit upside-down (up 0 1 0)) -1/2 1e-10)
  (define (moved s) (/ (square (+ 10 (momentum s))) 2))
  (check-= (action-of-orbit moved (up 0 0 -9) #:turn turn) -9 1e-10))

(test-case "a coordinate that is no angle of that turn"
  (check-exn #rx"does not come again after a turn of 3"
             (lambda () (action-of-orbit (turning 1) (up 0 0 5) #:turn 3))))
