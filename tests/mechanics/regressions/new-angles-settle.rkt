#lang racket/base
;; Terms that presentation put together, sin 2 of 2 sin 1 cos 1 or an angle sum of
;; hyperbolic functions, were put together further when simplified again; and
;; (x²)^(1/3) became x^(2/3) without a word about the sign of x.

(require mechanics "../support/checks.rkt")

(define (check-settled e)
  (define once (simplify e))
  (check-equal? (simplify once) once))

(test-case "a result simplified again stays as it is"
  (check-settled (expt (sin (+ (acos 'a) 1)) 2))
  (check-settled (+ (tanh 1) (tanh (+ (* 2 'a 'a) (* -1/3 'a) -1)))))

(test-case "the cube root of a square takes a sign for granted, and says so"
  (check-equal? (verdict-assumptions (prove-zero (- (expt (expt 'a 2) 3/2) (expt 'a 3))))
                '((>= a 0))))
