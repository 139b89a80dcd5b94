#lang racket/base
;; The greatest common divisor of polynomials.

(require "arithmetic.rkt" "structure.rkt" "content.rkt" "remainder-gcd.rkt")

(provide poly-gcd poly-gcd*)

;; The gcd over the rationals as a primitive integer polynomial with positive
;; leading coefficient; 0 when both are 0.
(define (poly-gcd R p q)
  (cond [(null? p) (primitive-part R q)]
        [(null? q) (primitive-part R p)]
        [else (primitive-part R (remainder-gcd R (primitive-part R p) (primitive-part R q)))]))

(define (primitive-part R p)
  (define-values (c primitive) (poly-primitive R p))
  primitive)

(define (poly-gcd* R ps)
  (for/fold ([g '()]) ([p (in-list ps)]
                       #:break (and (pair? g) (poly-constant? g)))
    (poly-gcd R g p)))
