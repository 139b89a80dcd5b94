#lang racket/base
;; Of an exponent that makes some brackets right, and others wrong whatever else is chosen, it was
;; said that all are; one that has no value there ended the question with a division by zero.

(require mechanics "../support/checks.rkt")

(define (remarks C state) (verdict-remarks (verify-canonical C state)))

;; Polar coordinates with a power of the momentum, beside a coordinate that is stretched alone
(define ((beside stretch) (up t (up theta y) (down I p)))
  (define r (* 'beta (expt I 'alpha)))
  (up t
      (up (* r (sin theta)) (* stretch 'alpha y))
      (down (* r (cos theta)) p)))
(define two (up 't (up 'theta 'y) (down 'I 'p)))

(test-case "a condition makes all of the residual zero"
  (check-equal? (remarks (beside 2) two)
                '("it is zero at all states if alpha = 1/2 and (expt beta 2) = 2"))
  (check-equal? (remarks (beside 3) two) '()))

(define line (up 't 'q 'p))

(test-case "an exponent for which the transformation has no value is none"
  (define (C s)
    (up (time s)
        (/ (expt (coordinate s) 'a) 'a)
        (* (momentum s) (expt (coordinate s) (- 1 (square 'a))))))
  (check-equal? (remarks C line) '("it is zero at all states if a = 1"))
  (define (without-value (up t (up x y) (down px py)))
    (up t (up (expt x 'b) (/ y (- 'b 1))) (down px (* py (- 'b 1)))))
  (define v (verify-canonical without-value (up 't (up 'x 'y) (down 'px 'py))))
  (check-pred refuted? v)
  (check-equal? (verdict-remarks v) '()))
