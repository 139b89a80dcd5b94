#lang racket/base
;; Greatest common divisors by primitive remainder sequences: slow, but it
;; always ends with the right answer.
;;
;; In ℚ[y...][x] a pseudo-remainder r = lc(q)^k p mod q keeps the common
;; divisors of p and q up to factors free of x.  So gcd(p, q) is
;; gcd(content p, content q), a gcd in fewer variables, times the last nonzero
;; primitive part of p, q, r, ....  The pseudo-remainders exceed the degrees of
;; p and q in the other variables, so all happens in a wider ring.

(require "ring.rkt" "arithmetic.rkt" "structure.rkt" "division.rkt" "content.rkt"
         "rering.rkt")

(provide remainder-gcd)

;; A gcd over the rationals, primitive, of nonzero p and q.
(define (remainder-gcd R p q)
  (define W (make-ring (ring-size R)
                       (* 4 (+ (poly-total-degree R p) 1) (+ (poly-total-degree R q) 1))))
  (rering W R (primitive-gcd W (rering R W p) (rering R W q))))

(define (primitive-gcd R p q)
  (cond [(null? p) (primitive R q)]
        [(null? q) (primitive R p)]
        [(or (poly-constant? p) (poly-constant? q)) (poly-constant R 1)]
        [else
         (define x (car (poly-variables R (poly+ R (ones p) (ones q)))))
         (define p-content (content-in R p x))
         (define q-content (content-in R q x))
         (define content (primitive-gcd R p-content q-content))
         (primitive R
                    (poly* R content
                           (remainder-sequence R x
                                               (poly-divide R p p-content)
                                               (poly-divide R q q-content))))]))

(define (ones p) (for/list ([t (in-list p)]) (cons (car t) 1)))

(define (primitive R p)
  (define-values (c pp) (poly-primitive R p))
  pp)

;; The gcd of the coefficients of p in variable x.
(define (content-in R p x)
  (for/fold ([g '()]) ([c (in-list (poly-coefficients R p x))]
                       #:break (and (pair? g) (poly-constant? g)))
    (primitive-gcd R g (cdr c))))

(define (remainder-sequence R x p q)
  (cond [(< (poly-degree R p x) (poly-degree R q x)) (remainder-sequence R x q p)]
        [(eq? 0 (poly-degree R q x)) (poly-constant R 1)]
        [else
         (define r (pseudo-remainder R x p q))
         (if (null? r)
             q
             (remainder-sequence R x q (primitive R (poly-divide R r (content-in R r x)))))]))

(define (pseudo-remainder R x p q)
  (define divisor (poly-coefficients R q x))
  (define n (caar divisor))
  (define lead (cdar divisor))
  (define tail (poly-from-coefficients R x (cdr divisor)))
  (let loop ([p p])
    (define cs (poly-coefficients R p x))
    (cond [(or (null? cs) (< (caar cs) n)) p]
          [else
           (define rest (poly-from-coefficients R x (cdr cs)))
           (define shifted
             (poly-from-coefficients R x (list (cons (- (caar cs) n) (cdar cs)))))
           (loop (poly- R (poly* R lead rest) (poly* R shifted tail)))])))
