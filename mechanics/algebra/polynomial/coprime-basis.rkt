#lang racket/base
;; Factor refinement: products of powers written over pairwise coprime factors.
;;
;; A *basis* is a list of powers (power.rkt) of polynomials that are
;; primitive, not constant and pairwise coprime.  Multiplying it by x^e, when
;; x and a member b^k share the divisor d, replaces
;;
;;     b^k x^e = (b/d)^k d^(k+e) (x/d)^e
;;
;; and inserts the three anew; degrees fall, so it ends.  Exponents may be of
;; any kind that `add` adds, so that one pass can follow two products at once.

(require "division.rkt" "gcd.rkt" "monomial.rkt" "polynomial-parts.rkt" "power.rkt" "term-list.rkt")

(provide basis-insert basis-sort basis=?)

;; The basis times polynomial^exponent; a constant polynomial leaves it alone.
(define (basis-insert R add basis polynomial exponent)
  (cond [(poly-constant? polynomial) basis]
        [else
         (define same (findf (lambda (b) (poly=? (power-base b) polynomial)) basis))
         (if same
             (replace basis same (make-power polynomial (add (power-exponent same) exponent)))
             (refine R add basis polynomial exponent))]))

(define (replace basis old new)
  (for/list ([b (in-list basis)]) (if (eq? b old) new b)))

(define (refine R add basis x e)
  (let loop ([bs basis] [coprime '()])
    (cond [(null? bs) (cons (make-power x e) basis)]
          [else
           (define b (power-base (car bs)))

           (define d (poly-gcd R b x))
           (if (poly-constant? d)
               (loop (cdr bs) (cons (car bs) coprime))
               (split R add (append coprime (cdr bs)) b (power-exponent (car bs)) d x e))])))

(define (split R add others b k d x e)
  (let* ([basis (basis-insert R add others d (add k e))]
         [basis (basis-insert R add basis (poly-divide R b d) k)])
    (basis-insert R add basis (poly-divide R x d) e)))

;; ---------------------------------------------------------------------------
;; Order

(define (basis-sort basis)
  (if (or (null? basis) (null? (cdr basis)))
      basis
      (sort basis poly<? #:key power-base)))

(define (poly<? p q)
  (cond [(null? q) #f]
        [(null? p) #t]
        [else
         (define m (leading-monomial p))
         (define n (leading-monomial q))
         (define c (leading-coefficient p))
         (define d (leading-coefficient q))
         (cond [(not (monomial=? m n)) (monomial>? n m)]
               [(not (= c d)) (< c d)]
               [else (poly<? (cdr p) (cdr q))])]))

;; Are two sorted bases the same members to the same integer powers?
(define (basis=? a b)
  (cond [(eq? a b) #t]
        [(or (null? a) (null? b)) #f]
        [else (and (eqv? (power-exponent (car a)) (power-exponent (car b)))
                   (poly=? (power-base (car a)) (power-base (car b)))
                   (basis=? (cdr a) (cdr b)))]))
