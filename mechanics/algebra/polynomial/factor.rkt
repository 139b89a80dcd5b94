#lang racket/base
;; Factors of polynomials over the rationals.
;;
;; Multiplicities, and factors with different variables, are told apart by gcds
;; (gcd-splitting.rkt).  Then no factor is free of a variable that occurs: so
;; it is irreducible if it is linear in one.  A homogeneous polynomial is factored
;; with one variable set to 1, which takes nothing away.

(require "arithmetic.rkt" "content.rkt" "coprime-basis.rkt" "integer-factor.rkt"
         "polynomial-parts.rkt"
         "lifted-factor.rkt" "monomial.rkt" "gcd-splitting.rkt" "power.rkt" "ring.rkt"
         "term-list.rkt")

(provide poly-factor)

;; Powers of factors that are primitive, with positive leading coefficients; their
;; product is p up to a rational factor.  Factors are irreducible, but for
;; those that were too much work.  Those of low degree come first, and among them
;; those with the first variables.
(define (poly-factor R p)
  (define factors
    (for*/list ([part (in-list (poly-parts R p))]
                [f (in-list (part-factors R (power-base part)))])
      (make-power f (power-exponent part))))
  (sort (basis-sort factors) (lambda (p q) (before? R p q)) #:key power-base))

(define (before? R p q)
  (define m (poly-total-degree R p))
  (define n (poly-total-degree R q))
  (or (< m n)
      (and (eqv? m n) (monomial>? (leading-monomial p) (leading-monomial q)))))

(define (part-factors R p)
  (define variables (poly-variables R p))
  (cond [(single-term? p) (list p)]
        [(for/or ([i (in-list variables)]) (eqv? 1 (poly-degree R p i))) (list p)]
        [(null? (cdr variables)) (univariate-factors R p (car variables))]
        [(homogeneous? R p) (homogeneous-factors R p (car variables))]
        [else (lifted-factors R p)]))

;; ---------------------------------------------------------------------------
;; One variable

(define (univariate-factors R p x)
  (for/list ([f (in-list (integer-factors (poly->vector R p x)))])
    (vector->poly R f x)))

;; ---------------------------------------------------------------------------
;; Homogeneous polynomials

(define (homogeneous? R p)
  (define degree (poly-total-degree R p))
  (for/and ([t (in-list p)]) (eqv? degree (monomial-degree R (term-monomial t)))))

;; With x set to 1, factored, and each term brought to the degree of its factor.
(define (homogeneous-factors R p x)
  (for*/list ([f (in-list (poly-factor R (poly-substitute R p x (poly-constant R 1))))]
              [_ (in-range (power-exponent f))])
    (poly-primitive-part R (homogenized R (power-base f) x))))

(define (homogenized R p x)
  (define degree (poly-total-degree R p))
  (poly-sum R
    (for/list ([t (in-list p)])
      (define m (term-monomial t))
      (define room (- degree (monomial-degree R m)))
      (list (make-term (monomial+ m (variable-power R x room)) (term-coefficient t))))))
