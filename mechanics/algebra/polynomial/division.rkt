#lang racket/base
;; Exact division: q divides p just when reducing p by q, leading term after
;; leading term, ends at zero.

(require "monomial.rkt" "ring.rkt" "arithmetic.rkt")

(provide poly-divide)

;; The exact quotient over the rationals, or #f when there is none.
(define (poly-divide R p q)
  (cond [(null? q) (raise-argument-error 'poly-divide "a nonzero polynomial" q)]
        [(null? p) '()]
        [(null? (cdr q)) (divide-by-term R p (caar q) (cdar q))]
        [else (divide R p q)]))

(define (divide-by-term R p m c)
  (and (for/and ([t (in-list p)]) (monomial-divides? (ring-guards R) m (car t)))
       (shift-terms (monomial- (ring-one R) m) (/ 1 c) p)))

(define (divide R p q)
  (define guards (ring-guards R))
  (define lead (caar q))
  (define lead-coefficient (cdar q))
  (let loop ([p p] [quotient '()])
    (cond [(null? p) (reverse quotient)]
          [(monomial-divides? guards lead (caar p))
           (define m (monomial- (caar p) lead))
           (define c (/ (cdar p) lead-coefficient))
           (loop (poly+ R (cdr p) (shift-terms m (- c) (cdr q)))
                 (cons (cons m c) quotient))]
          [else #f])))
