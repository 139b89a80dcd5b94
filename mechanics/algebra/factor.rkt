#lang racket/base
;; Factors that show without factoring: content, monomials, and common divisors
;; of the coefficients along each variable.
;;
;; If p = Σ cⱼ xʲ, the gcd of the cⱼ divides p.  Dividing it out for every
;; variable in turn splits products of polynomials in different variables, as
;; (k - mω²)(a cos ωt + b sin ωt).

(require "polynomial/polynomial.rkt")

(provide poly-visible-factors)

;; -> number and ((polynomial . exponent) ...), their product being p: first
;; single variables, then polynomials of several terms.
(define (poly-visible-factors R p)
  (define-values (c primitive) (poly-primitive R p))
  (define monomial (poly-monomial-content R primitive))
  (define variables
    (for/list ([e (in-vector monomial)] [i (in-naturals)] #:unless (eqv? e 0))
      (cons (poly-variable R i) e)))
  (define rest (divide-all R primitive variables))
  (values c (append variables (collect-equal (split R rest (poly-variables R rest))))))

(define (divide-all R p factors)
  (for/fold ([p p]) ([f (in-list factors)])
    (poly-divide R p (poly-expt R (car f) (cdr f)))))

;; A list of polynomials with product p, trying the variables given.
(define (split R p variables)
  (cond [(poly-constant? p) '()]
        [(null? variables) (list p)]
        [else
         (define g (poly-gcd* R (map cdr (poly-coefficients R p (car variables)))))
         (if (poly-constant? g)
             (split R p (cdr variables))
             (append (split R g (cdr variables))
                     (split R (poly-divide R p g) (cdr variables))))]))

(define (collect-equal ps)
  (for/fold ([factors '()] #:result (reverse factors)) ([p (in-list ps)])
    (define same (for/first ([f (in-list factors)] #:when (poly=? (car f) p)) f))
    (if same
        (for/list ([f (in-list factors)]) (if (eq? f same) (cons p (+ 1 (cdr f))) f))
        (cons (cons p 1) factors))))
