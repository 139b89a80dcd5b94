#lang racket/base
;; Values of polynomials at points, over any numbers and over prime fields.

(require mechanics/algebra/polynomial/modular
         mechanics/algebra/polynomial/ring
         mechanics/algebra/polynomial/term-list)

(provide poly-evaluate poly-evaluate-mod)

;; point : a vector of numbers, one a variable
(define (poly-evaluate R p point)
  (define (multiply i e value)
    (* value (expt (vector-ref point i) e)))
  (for/fold ([sum 0]) ([t (in-list p)])
    (+ sum (monomial-fold R (term-monomial t) multiply (term-coefficient t)))))

;; point : a vector of residues; prime : below 2^30, dividing no denominator
(define (poly-evaluate-mod R p point prime)
  (define (multiply i e value)
    (mod* value (mod-expt (vector-ref point i) e prime) prime))
  (for/fold ([sum 0]) ([t (in-list p)])
    (define c (residue (term-coefficient t) prime))
    (mod+ sum (monomial-fold R (term-monomial t) multiply c) prime)))
