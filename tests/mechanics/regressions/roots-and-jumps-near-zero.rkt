#lang racket/base
;; A root, or a jump, of an argument that is 0 but for rounding is no refutation;
;; the slope there once bounded the error, where there is none.

(require mechanics "../support/checks.rkt")

(define (status x) (verdict-status (prove-zero x)))

(test-case "the sign of what is 0 within rounding is not known"
  (define long (log (+ 'x (sqrt (+ 1 (square 'x))))))
  (check-not-eq? (status (sgn (- long (asinh 'x)))) 'refuted)
  (check-eq? (status (sgn (- long (* 2 (asinh 'x))))) 'refuted))

(test-case "nor is its root"
  (define x^2+1 (+ 1 (square 'x)))
  (check-not-eq? (status (sqrt (- (cosh (acosh x^2+1)) x^2+1))) 'refuted)
  (check-eq? (status (sqrt (- (cosh (acosh x^2+1)) 'x))) 'refuted))

(test-case "relatives: the angle at the cut, and a small power"
  (define zero (- (exp (log 'x)) 'x))
  (check-not-eq? (status (- (atan zero -1) :pi)) 'refuted)
  (define no-sine (- (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x))))
  (check-not-eq? (status (- (atan no-sine (- -1 (square 'x))) :pi)) 'refuted)
  (check-not-eq? (status (expt (- (cosh (asinh 'x)) (sqrt (+ 1 (square 'x)))) 1/3)) 'refuted))
