#lang racket/base
;; Partial fractions in one kernel s, over the field of the others.
;;
;; The denominator is a product of powers Pᵢ = Dᵢ^eᵢ, pairwise coprime as
;; polynomials in s.  The value is a polynomial in s plus Σ Uᵢ/Pᵢ, where
;;
;;     Uᵢ = N · (D/Pᵢ)⁻¹  modulo Pᵢ,
;;
;; and the digits of Uᵢ to the base Dᵢ are the numerators over Dᵢ^eᵢ, ..., Dᵢ.
;; It is as fine as the factors Dᵢ that are found.

(require "field.rkt" "univariate.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide split-in-kernel (struct-out over-power))

;; numerator / base^exponent : a polynomial in s (univariate.rkt) over a power of one
;; of the ring
(struct over-power (numerator base exponent) #:authentic)

;; i : the index of s
;; -> the polynomial in s, and the list of terms over powers
(define (split-in-kernel F f i)
  (define-values (below factors) (split-denominator F f i))
  (define N
    (u:scale F below (poly->univariate F i (fraction-numerator f))))
  (define bases (for/list ([h (in-list factors)]) (poly->univariate F i (power-base h))))
  (define powers
    (for/list ([b (in-list bases)] [h (in-list factors)]) (u:expt F b (power-exponent h))))
  (define-values (whole rest) (u:divide F N (product F powers)))
  (values whole
          (for*/list ([(b P h) (in-parallel bases powers factors)]
                      [U (in-value (numerator-over F rest P (remq P powers)))]
                      [digit (in-list (digits F U b h))])
            digit)))

;; -> the inverse of the part free of s, and powers of the other factors.
(define (split-denominator F f i)
  (define R (field-ring F))
  (for*/fold ([below (fraction-constant R 1)] [factors '()])
             ([h (in-list (fraction-denominator-factors f))]
              [g (in-list (poly-factor R (power-base h)))])
    (define p (power-base g))
    (define e (* (power-exponent g) (power-exponent h)))
    (if (zero? (poly-degree R p i))
        (values (fraction/ R below (fraction-from-poly R (poly-expt R p e))) factors)
        (values below (cons (make-power p e) factors)))))

(define (product F ps)
  (for/fold ([p (poly->univariate F 0 (poly-constant (field-ring F) 1))]) ([q (in-list ps)])
    (u:* F p q)))

;; U with rest over all powers being U/P and more over the others.
(define (numerator-over F rest P others)
  (define-values (_q U)
    (u:divide F (u:* F rest (u:inverse F (product F others) P)) P))
  U)

;; U/P, P = b^e, as digits over b^e, ..., b that are not zero; h is the power of the ring.
(define (digits F U b h)
  (let loop ([U U] [e (power-exponent h)])
    (cond [(null? U) '()]
          [else
           (define-values (higher digit) (u:divide F U b))
           (define others (loop higher (- e 1)))
           (if (null? digit)
               others
               (cons (over-power digit (power-base h) e) others))])))
