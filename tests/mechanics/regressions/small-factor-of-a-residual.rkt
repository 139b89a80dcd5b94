#lang racket/base
;; A residual that is printed as a small multiple of a sine is refuted, though the long form
;; loses it to rounding: the verdict was once undecided.

(require mechanics "../support/checks.rkt")

(define small (expt 10 -12))

(test-case "a millionth of a millionth is no zero"
  (define long (- (expt (+ 1000 (sin 'x)) 2) (square (sin 'x)) (* 2000 (sin 'x)) 1000000))
  (define v (prove-zero (- long (* small (sin 'x)))))
  (check-eq? (verdict-status v) 'refuted)
  (check-= (verdict-value v) (* -1e-12 (sin (cdar (verdict-witness v)))) 1e-26))

(test-case "nor is less, in an identity that no algebra sees"
  (define zero (* 'x (- (atan (tan (sin 'x))) (sin 'x))))
  (check-not-eq? (verdict-status (prove-zero zero)) 'refuted)
  (define v (prove-zero (+ zero (* (expt 10 -60) 'y))))
  (check-eq? (verdict-status v) 'refuted)
  (check-true (< 0 (abs (verdict-value v)) 1e-58)))
