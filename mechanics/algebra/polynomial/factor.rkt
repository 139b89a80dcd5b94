#lang racket/base
;; Factors of polynomials over the rationals.

(require "parts.rkt")

(provide poly-factor)

;; ((factor . multiplicity) ...): primitive, with positive leading coefficients;
;; their product is p up to a rational factor.
(define (poly-factor R p) (poly-parts R p))
