#lang racket/base
;; A value as a linear combination of basic fractions, the same for equal values.
;;
;; The terms that an angle or an exponent is a sum of must add up as the angles do, or
;; e^(a + b) is not e^a e^b: over its common denominator z + x/(1 + y) has the terms
;; x/(1 + y), z/(1 + y) and yz/(1 + y), and z by itself has others.  Partial fractions in
;; one variable after the other do add up.  In x, over the field of the variables that
;; follow, a value is in one way only a sum of
;;
;;     c xᵏ  and  c xⁱ/pʲ,   p irreducible, i less than the degree of p in x,
;;
;; and so is each c in the variables that follow: the products of these powers and
;; quotients, one for each variable, are a basis over the rationals.
;;
;; Sines, roots and absolute values come first.  They stand in numerators only, but for
;; long denominators, which are taken as they are: their products are not told apart.
;; Where it would be much work the terms of the numerator have to do.

(require racket/list
         "present.rkt"
         "../expression/exact-numbers.rkt" "../expression/simplifier.rkt"
         "../field/field.rkt" "../field/partial-fractions.rkt" "../field/work-bounds.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide linear-parts)

;; -> ((number . expression) ...), whose sum f is
(define (linear-parts F f)
  (or (and (compound-denominator? f)
           (separable? F f)
           (within-a-step (simplifier-fuel (field-simplifier F))
                          (lambda () (with-room F f presented-parts))))
      (linear-terms F f)))

(define (compound-denominator? f)
  (for/or ([h (in-list (fraction-denominator-factors f))])
    (> (poly-term-count (power-base h)) 1)))

(define (presented-parts F f)
  (for/list ([p (in-list (fraction-parts F f (variables-in-order F f)))])
    (cons (present-number (part-coefficient p) (field-inexact? F))
          (present F (part-basis p)))))

;; ---------------------------------------------------------------------------
;; Separable fractions

;; A denominator may be of this degree and have so many terms.
(define degree-bound 60)
(define term-bound 200)

(define (separable? F f)
  (define terms
    (for/sum ([h (in-list (fraction-denominator-factors f))])
      (* (power-exponent h) (poly-term-count (power-base h)))))
  (and (<= (fraction-denominator-degree (field-ring F) f) degree-bound)
       (<= terms term-bound)
       (<= (poly-term-count (fraction-numerator f)) term-bound)))

;; Variables with relations, then the others, by rank.
(define (variables-in-order F f)
  (define (rank i) (kernel-rank (field-kernel F i)))
  (define occurring
    (remove-duplicates
     (append-map (lambda (p) (poly-variables (field-ring F) p))
                 (cons (fraction-numerator f)
                       (map power-base (fraction-denominator-factors f))))
     eqv?))
  (define-values (algebraic others) (partition (lambda (i) (relation-of F i)) occurring))
  (append (sort algebraic < #:key rank) (sort others < #:key rank)))

;; ---------------------------------------------------------------------------
;; Parts

;; coefficient · basis, a rational number and a fraction
(struct part (coefficient basis) #:authentic)

(define (fraction-parts F f variables)
  (cond [(fraction-zero? f) '()]
        [(null? variables)
         (list (part (poly-constant-value (fraction-numerator f))
                     (fraction-constant (field-ring F) 1)))]
        [else
         (for*/list ([d (in-list (digits-in F f (car variables)))]
                     [p (in-list (fraction-parts F (digit-coefficient d) (cdr variables)))])
           (part (part-coefficient p)
                 (fraction* (field-ring F) (part-basis p) (digit-quotient d))))]))

;; A coefficient, free of a variable, and its other factor: a power of the variable, or
;; one over a power of an irreducible polynomial.
(struct digit (coefficient quotient) #:authentic)

(define (digits-in F f i)
  (define-values (whole parts) (split-in-kernel F f i))
  (define R (field-ring F))
  (define (over-one k) (fraction-from-poly R (poly-variable R i k)))
  (append (coefficient-digits whole over-one)
          (for*/list ([p (in-list parts)]
                      [below (in-value (fraction-from-poly
                                        R (poly-expt R (over-power-base p)
                                                     (over-power-exponent p))))]
                      [d (in-list (coefficient-digits
                                   (over-power-numerator p)
                                   (lambda (k) (fraction/ R (over-one k) below))))])
            d)))

;; Of a polynomial in one variable, highest power first.
(define (coefficient-digits coefficients quotient)
  (for/fold ([digits '()]) ([c (in-list coefficients)] [k (in-naturals)]
                            #:unless (fraction-zero? c))
    (cons (digit c (quotient k)) digits)))
