#lang racket/base
;; Content: the numeric and the monomial factor every term shares.

(require "arithmetic.rkt" "monomial.rkt" "power.rkt" "ring.rkt" "term-list.rkt")

(provide poly-content poly-primitive poly-primitive-part common-monomial split-monomial)

;; The positive rational c for which p/c has coprime integer coefficients: the
;; gcd of the numerators over the lcm of the denominators; 0 for zero.
(define (poly-content p)
  (let loop ([p p] [numerators 0] [denominators 1])
    (cond [(null? p) (/ numerators denominators)]
          [(and (eq? numerators 1) (andmap integral? p)) (/ 1 denominators)]
          [else
           (define c (leading-coefficient p))
           (loop (cdr p)
                 (gcd numerators (numerator c))
                 (if (integer? c) denominators (lcm denominators (denominator c))))])))

(define (integral? t) (integer? (term-coefficient t)))

;; -> content primitive.  The content bears the sign, so that the primitive
;; part has a positive leading coefficient and p = content · primitive.
(define (poly-primitive R p)
  (cond [(null? p) (values 0 '())]
        [else
         (define size (poly-content p))
         (define content (if (negative? (leading-coefficient p)) (- size) size))
         (values content
                 (if (eqv? content 1) p (poly-scale R (/ 1 content) p)))]))

(define (poly-primitive-part R p)
  (define-values (content primitive) (poly-primitive R p))
  primitive)

;; The greatest monomial that divides p.
(define (common-monomial R p)
  (if (null? p)
      (ring-one R)
      (let loop ([m (leading-monomial p)] [p (cdr p)])
        (if (or (null? p) (monomial-one? m))
            m
            (loop (monomial-gcd R m (leading-monomial p)) (cdr p))))))

;; -> powers of the variables that divide p, as polynomials, and the rest of p
(define (split-monomial R p)
  (define m (common-monomial R p))
  (values (for/list ([v (in-list (monomial-factors R m))])
            (make-power (poly-variable R (power-base v)) (power-exponent v)))
          (divide-by-monomial R p m)))
