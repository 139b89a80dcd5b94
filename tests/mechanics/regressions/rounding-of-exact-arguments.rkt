#lang racket/base
;; The rounding of exact arguments is counted: true equations were once refuted by the
;; value that a cosine near 0, or the sine of a large number, made of such rounding.

(require mechanics "../support/checks.rkt")

(define (status x) (verdict-status (prove-zero x)))

(test-case "the reciprocal of a small cosine is no refutation"
  (define a (square 'x))
  (define b (/ 'x (+ 1 'y)))
  (define expanded (- (* (cos a) (cos b)) (* (sin a) (sin b))))
  (check-not-eq? (status (- (/ 1 (cos (+ a b))) (/ 1 expanded))) 'refuted)
  (check-eq? (status (- (/ 1 (cos (+ a b))) (/ 1 (+ expanded 1/1000000)))) 'refuted))

(test-case "the sign of a sine of a large number is that of the sine"
  (define u (expt 'x 30))
  (define (difference n)
    (- (sgn (sin (* 3 u))) (* (sgn (sin u)) (sgn (- n (* 4 (square (sin u))))))))
  (check-not-eq? (status (difference 3)) 'refuted)
  (check-eq? (status (difference 2)) 'refuted))

(test-case "a relative: the tangent of a sum near its pole"
  (define a (expt 'x 20))
  (define b (/ 'y 7))
  (define (difference n)
    (- (tan (+ a b)) (/ (+ (tan a) (tan b)) (- n (* (tan a) (tan b))))))
  (check-not-eq? (status (difference 1)) 'refuted)
  (check-eq? (status (difference 2)) 'refuted))
