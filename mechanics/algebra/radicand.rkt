#lang racket/base
;; Taking powers out of roots: (c^q w)^(1/q) = c w^(1/q).
;;
;; The radicand is factored into a number and square-free polynomials.  What is
;; taken out is assumed not to be negative, and that is told to `assume!`; an
;; even power need not be.

(require "collect.rkt" "field.rkt" "present.rkt" "exact.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide split-root)

;; -> outer inner, expressions with f^(1/q) = outer · inner^(1/q).
(define (split-root F f q assume!)
  (define R (field-ring F))
  (define one (poly-constant R 1))
  (define p (fraction-numerator f))
  (cond
    [(fraction-zero? f) (values 0 1)]
    [else
     (define factors
       (append (poly-square-free R p)
               (for/list ([h (in-list (fraction-denominator-factors f))])
                 (cons (car h) (- (cdr h))))))
     (define product (power-product R factors))
     (define number
       (/ (poly-leading-coefficient p)
          (poly-leading-coefficient (fraction-numerator (power-product R (poly-square-free R p))))))
     (define-values (c rest) (split-number number q (atlas-inexact? (field-atlas F))))
     (define-values (out in) (split-factors factors q))
     (for ([g (in-list out)] #:when (odd? (cdr g)))
       (assume! (present F (fraction-from-poly R (car g)))))
     (values (present F (fraction-scale R c (power-product R out)))
             (present F (fraction-scale R rest (power-product R in))))]))

(define (power-product R factors)
  (for/fold ([f (fraction-from-poly R (poly-constant R 1))]) ([g (in-list factors)])
    (fraction* R f (fraction-expt R (fraction-from-poly R (car g)) (cdr g)))))

;; x = c^q · rest.  A number that came from a flonum is split only if nothing
;; is left.
(define (split-number x q inexact?)
  (define n (square-part (abs (numerator x)) q))
  (define d (square-part (denominator x) q))
  (define c (/ n d))
  (define rest (/ x (expt c q)))
  (if (and inexact? (not (eqv? rest 1)))
      (values 1 x)
      (integral-rest c rest q)))

;; The rest as an integer: a/b = (a b^(q-1)) / b^q.
(define (integral-rest c rest q)
  (define b (denominator rest))
  (values (/ c b) (* rest (expt b q))))

(define (split-factors factors q)
  (for/fold ([out '()] [in '()] #:result (values (reverse out) (reverse in)))
            ([g (in-list factors)])
    (define k (quotient (cdr g) q))
    (define rest (- (cdr g) (* k q)))
    (values (if (eqv? k 0) out (cons (cons (car g) k) out))
            (if (eqv? rest 0) in (cons (cons (car g) rest) in)))))
