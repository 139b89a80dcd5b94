#lang racket/base
;; Power series one meets, about 0.

(require "coefficients.rkt" "series.rkt"
         "../../generic/arithmetic.rkt" "../../generic/elementary.rkt")

(provide exp-series sin-series cos-series sinh-series cosh-series atan-series
         binomial-series)

(define x (power-series-of (coefficients-from '(0 1))))

(define exp-series (g:exp x))
(define sin-series (g:sin x))
(define cos-series (g:cos x))
(define sinh-series (g:sinh x))
(define cosh-series (g:cosh x))
(define atan-series (g:atan x))

;; (1 + x)ⁿ for any n.
(define (binomial-series n) (g:expt (g:+ 1 x) n))
