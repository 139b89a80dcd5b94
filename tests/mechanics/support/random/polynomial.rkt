#lang racket/base
;; Polynomials by their exponents, and random ones.

(require mechanics/algebra/polynomial/polynomial)

(provide poly-monomial random-polynomial random-polynomials random-coefficient random-point)

;; exponents : a list or a vector, one a variable
(define (poly-monomial R coefficient exponents)
  (for/fold ([p (poly-constant R coefficient)]) ([e exponents] [i (in-naturals)])
    (poly* R p (poly-variable R i e))))

;; Up to `terms` terms of total degree up to `degree`, in a random choice of
;; variables, with coefficients from `coefficient`.
(define (random-polynomial R #:terms [terms 6] #:degree [degree 3]
                           #:coefficient [coefficient random-coefficient])
  (poly-sum R
            (for/list ([_ (in-range (random (+ terms 1)))])
              (poly-monomial R (coefficient) (random-exponents (ring-size R) degree)))))

(define (random-exponents n degree)
  (define v (make-vector n 0))
  (unless (eqv? n 0)
    (for ([_ (in-range (random (+ degree 1)))])
      (define i (random n))
      (vector-set! v i (+ 1 (vector-ref v i)))))
  v)

(define (random-polynomials R count . options)
  (for/list ([_ (in-range count)]) (random-polynomial R)))

;; Mostly small integers, sometimes a fraction or a large number.
(define (random-coefficient)
  (case (random 8)
    [(0) (/ (- (random 21) 10) (+ 1 (random 9)))]
    [(1) (* (- (random 3) 1) (expt 10 20) (+ 1 (random 100)))]
    [else (- (random 21) 10)]))

(define (random-point n)
  (for/vector #:length n ([_ (in-range n)]) (random-coefficient)))
