#lang racket/base
;; Sparse polynomials in many variables over the rationals.
;;
;; Every operation takes its ring first; operands must belong to that ring.  A
;; result whose total degree would pass the ring's bound raises
;; exn:algebra:degree-overflow.

(require "arithmetic.rkt" "content.rkt" "division.rkt" "gcd.rkt" "polynomial-parts.rkt"
         "work-budget.rkt"
         "gcd-splitting.rkt" "power.rkt" "ring.rkt" "term-list.rkt")

(provide
 ;; rings
 make-ring ring-size ring-max-degree (struct-out exn:algebra:degree-overflow)
 ;; the cost of arithmetic
 make-meter meter-left meter-charge! meter-allow! meter-allow-all! overspent?
 ;; making
 poly-constant poly-variable
 ;; asking
 poly-zero? poly-constant? poly-constant-value poly=? poly-term-count
 poly-degree poly-total-degree poly-variables poly-leading-coefficient
 poly-terms poly-term-coefficient poly-term-powers
 ;; arithmetic
 poly+ poly- poly-negate poly* poly-scale poly-expt poly-sum poly-divide
 ;; divisors
 poly-gcd* poly-content poly-primitive poly-parts
 common-monomial monomial-factors divide-by-monomial
 ;; powers, of polynomials or of the variables in a term
 make-power power-base power-exponent raise-powers product-leading-coefficient
 ;; along one variable
 poly-coefficients poly-from-coefficients make-slice slice-degree slice-coefficient)
