#lang racket/base
;; Factor refinement: products of powers written over pairwise coprime factors.
;;
;; A *basis* is a list of (polynomial . exponent) whose polynomials are
;; primitive, not constant and pairwise coprime.  Multiplying it by x^e, when
;; x and a member b^k share the divisor d, replaces
;;
;;     b^k x^e = (b/d)^k d^(k+e) (x/d)^e
;;
;; and inserts the three anew; degrees fall, so it ends.  Exponents may be of
;; any kind that `add` adds, so that one pass can follow two products at once.

(require "division.rkt" "gcd.rkt" "inspect.rkt" "monomial.rkt")

(provide basis-insert basis-sort basis=?)

;; The basis times polynomial^exponent; a constant polynomial leaves it alone.
(define (basis-insert R add basis polynomial exponent)
  (cond [(poly-constant? polynomial) basis]
        [else
         (define same (find-equal basis polynomial))
         (if same
             (replace basis same (cons polynomial (add (cdr same) exponent)))
             (refine R add basis polynomial exponent))]))

(define (find-equal basis polynomial)
  (for/first ([b (in-list basis)] #:when (poly=? (car b) polynomial)) b))

(define (replace basis old new)
  (for/list ([b (in-list basis)]) (if (eq? b old) new b)))

(define (refine R add basis x e)
  (let loop ([bs basis] [coprime '()])
    (cond [(null? bs) (cons (cons x e) basis)]
          [else
           (define b (caar bs))
           (define d (poly-gcd R b x))
           (if (poly-constant? d)
               (loop (cdr bs) (cons (car bs) coprime))
               (split R add (append coprime (cdr bs)) b (cdar bs) d x e))])))

(define (split R add others b k d x e)
  (let* ([basis (basis-insert R add others d (add k e))]
         [basis (basis-insert R add basis (poly-divide R b d) k)])
    (basis-insert R add basis (poly-divide R x d) e)))

;; ---------------------------------------------------------------------------
;; Order

(define (basis-sort basis)
  (if (or (null? basis) (null? (cdr basis)))
      basis
      (sort basis (lambda (a b) (poly<? (car a) (car b))))))

(define (poly<? p q)
  (cond [(null? q) #f]
        [(null? p) #t]
        [(not (monomial=? (caar p) (caar q))) (monomial>? (caar q) (caar p))]
        [(not (= (cdar p) (cdar q))) (< (cdar p) (cdar q))]
        [else (poly<? (cdr p) (cdr q))]))

;; Are two sorted bases the same members to the same integer powers?
(define (basis=? a b)
  (cond [(eq? a b) #t]
        [(or (null? a) (null? b)) #f]
        [else (and (eqv? (cdar a) (cdar b))
                   (poly=? (caar a) (caar b))
                   (basis=? (cdr a) (cdr b)))]))
