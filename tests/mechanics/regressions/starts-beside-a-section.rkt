#lang racket/base
;; A start a little off the surface of section was taken for one on it, and a motion that rests
;; was followed for ever.

(require mechanics "../support/checks.rkt")

(define (oscillator s) (up 1 (momentum s) (- (coordinate s))))
(define (section of) (Poincare-map oscillator (event of #:direction 'rising)))

(test-case "from x = -d with p = 1 the motion rises through 0 after arctan d"
  (for ([d '(1e-3 1e-5 1e-7 1e-9 1e-10)])
    (check-= (time ((section coordinate) (up 0 (- d) 1))) (atan d) 1e-12)))

(test-case "and on the surface, or off it by rounding, a turn later"
  (for ([d '(0 1e-16 -1e-16 1e-13 -1e-13)])
    (check-= (time ((section coordinate) (up 0 d 1))) (* 2 :pi) 1e-11)))

(test-case "just below the top the motion falls through the surface soon after it rose"
  (for ([d '(1e-4 1e-6 1e-8)])
    (define x (- 1 d))
    (define next (Poincare-map oscillator (event (lambda (s) (- (coordinate s) x)))))
    (check-= (momentum (next (up 0 x (sqrt (- 1 (* x x))))))
             (- (sqrt (- 1 (* x x))))
             1e-5)))

(test-case "what rests never comes back, and that is said"
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda () ((section coordinate) (up 0 0 0))))
  (check-exn exn:fail:mechanics:not-convergent?
             (lambda () ((section (lambda (s) (- (coordinate s) 1))) (up 0 0 0)))))
