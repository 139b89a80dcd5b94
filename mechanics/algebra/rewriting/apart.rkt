#lang racket/base
;; Partial fractions in one kernel s: see field/partial-fractions.rkt.

(require "collect.rkt" "together.rkt"
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../field/field.rkt" "../field/partial-fractions.rkt" "../field/univariate.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
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
  (define-values (whole parts) (split-in-kernel F f i))
  (written F (append (monomials F i whole)
                     (for/list ([p (in-list parts)]) (part-fraction F i p)))))

(define (part-fraction F i p)
  (define R (field-ring F))
  (fraction/ R
             (univariate->fraction F i (over-power-numerator p))
             (fraction-expt R (fraction-from-poly R (over-power-base p)) (over-power-exponent p))))

;; The terms of a polynomial in s, highest first.
(define (monomials F i p)
  (define R (field-ring F))
  (for/fold ([terms '()]) ([c (in-list p)] [k (in-naturals)] #:unless (fraction-zero? c))
    (cons (fraction* R c (fraction-from-poly R (poly-variable R i k))) terms)))

(define (written F fractions)
  (form-expression
   (sum-form (for/list ([f (in-list fractions)]) (expression->form (quotient-expression F f))))))
