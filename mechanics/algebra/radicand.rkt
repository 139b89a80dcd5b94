#lang racket/base
;; Taking powers out of roots: (c^q w)^(1/q) = c w^(1/q).
;;
;; The radicand is factored into a number and square-free polynomials.  What is
;; taken out is assumed not to be negative, and that is told to `assume!`; an
;; even power need not be.

(require "field.rkt" "squares.rkt" "present.rkt" "exact.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide split-root fraction-factors)

;; -> outer inner, expressions with f^(1/q) = outer · inner^(1/q).
(define (split-root F f q assume!)
  (define R (field-ring F))
  (cond
    [(fraction-zero? f) (values 0 1)]
    [else
     (define-values (number factors) (value-parts F f))
     (define-values (c rest) (split-number number q (field-inexact? F)))
     (define-values (out in) (split-factors factors q))
     (for ([g (in-list out)] #:when (odd? (cdr g)))
       (assume! (present F (fraction-from-poly R (car g)))))
     (values (present F (fraction-scale R c (power-product R out)))
             (present F (fraction-scale R rest (power-product R in))))]))

;; -> number and ((polynomial . integer) ...), whose product f is: the parts of
;; numerator and denominator.  In the form with fewest terms 1 - cos² is a square.
(define (value-parts F f)
  (define R (field-ring F))
  (define p (shortest-squares F (fraction-numerator f)))
  (define above (poly-parts R p))
  (define below (fraction-denominator-parts R f))
  (values (/ (* (poly-leading-coefficient p) (leading below))
             (* (leading above) (leading (fraction-denominator-factors f))))
          (append above (for/list ([h (in-list below)]) (cons (car h) (- (cdr h)))))))

(define (leading factors)
  (for/fold ([c 1]) ([h (in-list factors)])
    (* c (expt (poly-leading-coefficient (car h)) (cdr h)))))

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

;; The fraction as a number and ((expression . integer) ...), factors with a
;; positive leading coefficient.
(define (fraction-factors F f)
  (define R (field-ring F))
  (cond [(fraction-zero? f) (values 0 '())]
        [else
         (define-values (number parts) (value-parts F f))
         (values number
                 (for/list ([g (in-list parts)])
                   (cons (present F (fraction-from-poly R (car g))) (cdr g))))]))
