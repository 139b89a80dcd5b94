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

(require "collect.rkt" "together.rkt"
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../field/field.rkt" "../field/univariate.rkt"
         "../polynomial/factor.rkt" "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/form.rkt"
         "../simplify/simplify-expression.rkt")

(provide partial-fractions)

;; chosen : a symbol or literal function applied -> expression and assumptions
(define (partial-fractions e chosen [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (define variables (find-kernels F (list chosen) A))
  (values (if (null? variables)
              (quotient-expression F f)
              (with-room F f (lambda (F f) (sum-of-parts F f (car variables)))))
          assumptions))

(define (sum-of-parts F f i)
  (define-values (below factors) (split-denominator F f i))
  (define N
    (u:scale F below (poly->univariate F i (fraction-numerator f))))
  (define bases (for/list ([h (in-list factors)]) (poly->univariate F i (power-base h))))
  (define powers
    (for/list ([b (in-list bases)] [h (in-list factors)]) (u:expt F b (power-exponent h))))
  (define-values (whole rest) (u:divide F N (product F powers)))
  (define proper
    (for*/list ([(b P h) (in-parallel bases powers factors)]
                [part (in-list (part-fractions F i rest b P (power-exponent h) (remq P powers)))])
      part))
  (written F (append (monomials F i whole) proper)))

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

;; The fractions u_j / b^(e-j) that add up to the part of rest over P = b^e.
(define (part-fractions F i rest b P e others)
  (define R (field-ring F))
  (define-values (_q U)
    (u:divide F (u:* F rest (u:inverse F (product F others) P)) P))
  (define base (univariate->fraction F i b))
  (let loop ([U U] [e e])
    (cond [(null? U) '()]
          [else
           (define-values (higher digit) (u:divide F U b))
           (define others (loop higher (- e 1)))
           (if (null? digit)
               others
               (cons (fraction/ R (univariate->fraction F i digit) (fraction-expt R base e))
                     others))])))

;; The terms of a polynomial in s, highest first.
(define (monomials F i p)
  (define R (field-ring F))
  (for/fold ([terms '()]) ([c (in-list p)] [k (in-naturals)] #:unless (fraction-zero? c))
    (cons (fraction* R c (fraction-from-poly R (poly-variable R i k))) terms)))

(define (written F fractions)
  (define forms
    (for/list ([f (in-list fractions)]) (expression->form (quotient-expression F f))))
  (if (null? forms) 0 (form-expression (sum-form forms))))
