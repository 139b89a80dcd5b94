#lang racket/base
;; Derivatives and integrals of series, and the inverse function of a power series.

(require "coefficients.rkt" "series.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/wrong-argument.rkt")

(provide series:derivative series:integral series:reversion)

;; Σ (k+1) a_{k+1} xᵏ
(define (series:derivative s)
  (check-power-series 'series:derivative s)
  (power-series-of
   (make-coefficients (lambda (k) (g:* (add1 k) (series-term s (add1 k))))
                      (max 0 (sub1 (series-length s))))))

;; constant + Σ a_{k-1} xᵏ/k
(define (series:integral s [constant 0])
  (check-power-series 'series:integral s)
  (power-series-of
   (make-coefficients (lambda (k) (if (eqv? k 0) constant (g:/ (series-term s (sub1 k)) k)))
                      (add1 (series-length s)))))

;; The power series t with s(t(x)) = x, by Lagrange's inversion formula: with
;; s = x/φ, coefficient k of t is 1/k times coefficient k-1 of φᵏ.
(define (series:reversion s)
  (check-power-series 'series:reversion s)
  (unless (eqv? (series-term s 0) 0)
    (complain-showing 'series:reversion "the series must begin with 0" "series" s))
  (define slopes                        ; s/x
    (power-series-of
     (make-coefficients (lambda (k) (series-term s (add1 k))) (sub1 (series-length s)))))
  (when (or (< (series-length s) 2) (eqv? (series-term s 1) 0))
    (complain-showing 'series:reversion "the coefficient of x must not be 0" "series" s))
  (define φ (g:/ 1 slopes))
  (define powers (powers-of φ))
  (power-series-of
   (make-coefficients
    (lambda (k)
      (if (eqv? k 0) 0 (g:/ (series-term (coefficient powers k) (sub1 k)) k))))))

(define (check-power-series who s)
  (unless (power-series? s)
    (complain-of-argument
     who "a power series" s
     (if (series? s)
         (string-append "\n  a series of terms has no variable; "
                        "(series:->function s) takes its terms as coefficients")
         ""))))
