#lang racket/base
;; Series, made and looked at: as many terms as one wants.

(require "coefficients.rkt" "series.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/sums-and-products.rkt"
         "../../generic/wrong-argument.rkt")

(provide
 series power-series series:generate series:->function
 series:finite? series:ref series:head series:sum series:for-each partial-sums
 for-each-term)

;; ---------------------------------------------------------------------------
;; Making

;; a₀ + a₁ + ⋯, and no more terms.
(define (series . terms) (series-of (coefficients-from terms)))
(define (power-series . terms) (power-series-of (coefficients-from terms)))

;; The series whose term of order k is (f k).  The arity is for scmutils; here the terms tell
;; their own.
(define (series:generate f [arity #f])
  (unless (and (procedure? f) (procedure-arity-includes? f 1))
    (complain-of-argument 'series:generate "a function of the order of a term" f))
  (series-of (make-coefficients f)))

;; The power series with these terms as coefficients.
(define (series:->function s)
  (check-series 'series:->function s)
  (power-series-of (series-coefficients s)))

;; ---------------------------------------------------------------------------
;; Looking

(define (series:finite? s)
  (check-series 'series:finite? s)
  (finite-series? s))

;; The list of the first n terms.
(define (series:head s n)
  (check-series 'series:head s)
  (check-argument 'series:head exact-nonnegative-integer? n "a number of terms")
  (for/list ([k (in-range n)]) (series-term s k)))

;; The sum of the terms up to order n, n + 1 of them (SICM p. 463).
(define (series:sum s n)
  (check-series 'series:sum s)
  (check-argument 'series:sum exact-nonnegative-integer? n "the order of the last term")
  (g:for/sum ([k (in-range (min (add1 n) (series-length s)))])
    (series-term s k)))

;; (f term) for the first n terms; for all of them, where they end.
(define (series:for-each f s [n #f])
  (check-argument 'series:for-each procedure? f "a function of a term")
  (for-each-term 'series:for-each "(series:for-each f s n)" f s n))

;; usage : how to say of how many terms
(define (for-each-term who usage f s n)
  (check-series who s)
  (when n (check-argument who exact-nonnegative-integer? n "a number of terms"))
  (unless (or n (finite-series? s))
    (complain-showing who
                      (string-append "the series does not end; say of how many terms: " usage)
                      "series" s))
  (for ([k (in-range (if n (min n (series-length s)) (series-length s)))])
    (f (series-term s k))))

;; a₀, a₀ + a₁, a₀ + a₁ + a₂, … as the terms of a series.
(define (partial-sums s)
  (check-series 'partial-sums s)
  (define sums
    (make-coefficients
     (lambda (k)
       (if (eqv? k 0) (series-term s 0) (g:+ (coefficient sums (sub1 k)) (series-term s k))))))
  (series-of sums))
