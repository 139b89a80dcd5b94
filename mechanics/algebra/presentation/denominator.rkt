#lang racket/base
;; The factors of a denominator: the parts that depend on the value alone, unless
;; the factors it came with have fewer terms; x² - 1, but the distances from two
;; centres apart.

(require "../field/field.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide denominator-factors)

;; Finding the parts of longer factors would cost more than it is worth.
(define parts-limit 100)

;; -> number and powers of polynomials, their product being the denominator of f.
(define (denominator-factors F f)
  (define R (field-ring F))
  (define given (fraction-denominator-factors f))
  (define factors
    (if (<= (additions given) parts-limit)
        (fewer-terms (fraction-denominator-parts R f) given)
        given))
  (values (/ (product-leading-coefficient given) (product-leading-coefficient factors))
          factors))

(define (fewer-terms parts given)
  (if (< (additions given) (additions parts)) given parts))

(define (additions factors)
  (for/sum ([h (in-list factors)]) (- (poly-term-count (power-base h)) 1)))
