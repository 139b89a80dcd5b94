#lang racket/base
;; Greatest common divisors by primitive remainder sequences: slow, but it
;; needs no luck and always ends with the right answer.
;;
;; A common divisor of p and q in ℚ[y...][x] divides every pseudo-remainder
;; r = lc(q)^k p mod q, and up to factors free of x the common divisors of q and
;; r are those of p and q.  So gcd(p, q) is the gcd of the contents of p and q in
;; x, which has fewer variables, times the last nonzero primitive part of
;; p, q, r, ....  Pseudo-remainders have higher degrees than p and q in the
;; other variables, hence a wider ring for each.

(require "arithmetic.rkt" "content.rkt" "division.rkt" "polynomial-parts.rkt" "ring.rkt"
         "ring-change.rkt"
         "term-list.rkt")

(provide remainder-gcd)

;; A gcd over the rationals, primitive; p and q not both 0.
(define (remainder-gcd R p q)
  (cond [(null? p) (poly-primitive-part R q)]
        [(null? q) (poly-primitive-part R p)]
        [(or (poly-constant? p) (poly-constant? q)) (poly-constant R 1)]
        [else
         (define x (car (poly-variables R p)))
         (define p-content (content-in R p x))
         (define q-content (content-in R q x))
         (define g
           (last-primitive R x (poly-divide R p p-content) (poly-divide R q q-content)))
         (poly-primitive-part R (poly* R (remainder-gcd R p-content q-content) g))]))

;; The gcd of the coefficients of p in variable x.
(define (content-in R p x)
  (for/fold ([g '()]) ([c (in-list (poly-coefficients R p x))])
    (remainder-gcd R g (slice-coefficient c))))

;; The last nonzero member of the sequence that begins with p and q.
(define (last-primitive R x p q)
  (define m (poly-degree R p x))
  (define n (poly-degree R q x))
  (cond [(< m n) (last-primitive R x q p)]
        [(eqv? n 0) (poly-constant R 1)]
        [else
         ;; every step of the division multiplies by a coefficient of q
         (define W
           (wider-ring R
                       (+ (poly-total-degree R p)
                          (* (+ m (- n) 1) (poly-total-degree R q)))))
         (define next (rering R W q))
         (define r (pseudo-remainder W x (rering R W p) next))
         (if (null? r)
             q
             (rering W R (last-primitive W x next (primitive-in W r x))))]))

;; p without its contents, numeric and in x.
(define (primitive-in R p x)
  (poly-primitive-part R (poly-divide R p (content-in R p x))))

(define (pseudo-remainder R x p q)
  (define divisor (poly-coefficients R q x))
  (define n (slice-degree (car divisor)))
  (define lead (slice-coefficient (car divisor)))
  (define tail (poly-from-coefficients R x (cdr divisor)))
  (let loop ([p p])
    (define cs (poly-coefficients R p x))
    (cond [(or (null? cs) (< (slice-degree (car cs)) n)) p]
          [else
           (define rest (poly-from-coefficients R x (cdr cs)))
           (define top
             (make-slice (- (slice-degree (car cs)) n) (slice-coefficient (car cs))))
           (loop (poly- R
                        (poly* R lead rest)
                        (poly* R (poly-from-coefficients R x (list top)) tail)))])))
