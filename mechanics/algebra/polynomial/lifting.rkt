#lang racket/base
;; Hensel lifting: a factorization of an image becomes one of the polynomial.
;;
;; Let p be monic in x, and let its image at y = 0, y being all other variables,
;; be g₀ h₀, monic and coprime.  When g h is right up to the terms of degree k - 1
;; in y, the terms of degree k of
;;
;;     p - g h = δg h₀ + δh g₀
;;
;; give the corrections δg and δh, one monomial in y after the other, from
;; u g₀ + v h₀ = 1.  After as many steps as p has degrees in y, g is the factor of
;; p that has the image g₀, if there is one: no other polynomial could be it.
;; Coefficients are residues modulo a prime above twice those a factor can have.

(require "arithmetic.rkt" "dense.rkt" "modular.rkt" "monomial.rkt" "polynomial-parts.rkt" "ring.rkt"
         "term-list.rkt")

(provide lift-factor)

;; Products of terms in one step, beyond which lifting is given up.
(define product-limit 200000)

;; -> the only candidate for a factor of p with image g₀, #f when that would be
;; too much work.  g₀, h₀ : dense polynomials modulo P
(define (lift-factor R p x g₀ h₀ P)
  (define-values (u v) (dense-bezout g₀ h₀ P))
  (define highest (degree-outside R p x))
  (let lift ([g (sparse R x g₀ (ring-one R) P)] [h (sparse R x h₀ (ring-one R) P)] [k 1])
    (cond [(> k highest) g]
          [(> (* (length g) (length h)) product-limit) #f]
          [else
           (define missing (terms-of-degree R (poly- R p (poly* R g h)) x k))
           (define-values (δg δh) (corrections R x missing g₀ h₀ u v P))
           (lift (poly+ R g δg) (poly+ R h δh) (+ k 1))])))

;; The greatest degree in all variables but x.
(define (degree-outside R p x)
  (greatest-of-terms p (lambda (t) (outside R (term-monomial t) x))))

(define (outside R m x) (- (monomial-degree R m) (monomial-exponent R m x)))

;; The terms of degree k in y: a table from monomials of y to vectors of integers.
(define (terms-of-degree R p x k)
  (define n (+ 1 (poly-degree R p x)))
  (define table (make-monomial-hash R))
  (for* ([t (in-list p)]
         [m (in-value (term-monomial t))]
         #:when (eqv? k (outside R m x)))
    (define e (monomial-exponent R m x))
    (define v
      (hash-ref! table (monomial- m (variable-power R x e)) (lambda () (make-vector n 0))))
    (vector-set! v e (term-coefficient t)))
  table)

(define (corrections R x missing g₀ h₀ u v P)
  (define-values (gs hs)
    (for/fold ([gs '()] [hs '()]) ([(m numbers) (in-hash missing)])
      (define c (dense numbers P))
      (define-values (k δg) (dense-divide (dense* v c P) g₀ P))
      (define-values (δh zero) (dense-divide (dense- c (dense* δg h₀ P) P) g₀ P))
      (values (cons (sparse R x δg m P) gs)
              (cons (sparse R x δh m P) hs))))
  (values (poly-sum R gs) (poly-sum R hs)))

;; The dense polynomial in x times the monomial m of y.
(define (sparse R x v m P)
  (vector->poly R (for/vector ([c (in-vector v)]) (symmetric-residue c P)) x m))
