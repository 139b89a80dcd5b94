#lang racket/base
;; Exact division: q divides p just when reducing p by q, leading term after
;; leading term, ends at zero.
;;
;; Subtracting every multiple of q from all of p would walk over p once a term
;; of the quotient.  Instead the multiples wait in buckets, a binary counter:
;; the i-th bucket is empty or holds the sum of up to 2^i multiples, and a full
;; one is added into the next.  The leading term of the remainder is found by
;; looking at the heads of p and of the few buckets.  So the cost is that of the
;; product of q and the quotient, by the same balanced additions.

(require racket/fixnum
         racket/list
         "arithmetic.rkt" "monomial.rkt" "ring.rkt" "term-list.rkt")

(provide poly-divide poly-divide-integral)

;; The exact quotient over the rationals, or #f when there is none.
(define (poly-divide R p q) (divide R p q #f))

;; The same over the integers, where a fraction tells early that there is none:
;; by Gauss's lemma that is no loss when p has integer coefficients and q is
;; primitive.
(define (poly-divide-integral R p q) (divide R p q #t))

(define (divide R p q integral?)
  (cond [(null? q) (raise-argument-error 'poly-divide "a nonzero polynomial" q)]
        [(null? p) '()]
        [(single-term? q) (divide-by-term R p (car q) integral?)]
        [(last-divides? R p q) (reduce R p q integral?)]
        [else #f]))

(define (divide-by-term R p divisor integral?)
  (define guards (ring-guards R))
  (define m (term-monomial divisor))
  (define c (term-coefficient divisor))
  (and (for/and ([t (in-list p)])
         (and (monomial-divides? guards m (term-monomial t))
              (or (not integral?) (integer? (/ (term-coefficient t) c)))))
       (shift-terms (monomial- (ring-one R) m) (/ 1 c) p)))

;; The last term of p is that of q times that of the quotient.
(define (last-divides? R p q)
  (monomial-divides? (ring-guards R) (term-monomial (last q)) (term-monomial (last p))))

;; ---------------------------------------------------------------------------
;; Reduction

;; Room for 2^30 terms of quotient.
(define bucket-count 32)

;; Buckets : a vector of polynomials, p in place 0; the remainder is their sum.
;; `used` places are not all empty.
(define (reduce R p q integral?)
  (define guards (ring-guards R))
  (define lead (leading-monomial q))
  (define lead-coefficient (leading-coefficient q))
  (define length-of-q (length q))
  (define buckets (make-vector bucket-count '()))
  (vector-set! buckets 0 p)
  (let loop ([quotient '()] [used 1])
    (define m (greatest-monomial buckets used))
    (cond [(not m) (reverse quotient)]
          [else
           (define c (take-coefficient! buckets used m))
           (define d (/ c lead-coefficient))
           (cond [(eq? c 0) (loop quotient used)]
                 [(and (monomial-divides? guards lead m)
                       (or (not integral?) (integer? d)))
                  (define n (monomial- m lead))
                  (charge! R length-of-q)
                  (define place (put! R buckets 1 (shift-terms n (- d) (cdr q))))
                  (loop (cons (make-term n d) quotient) (fxmax used (fx+ place 1)))]
                 [else #f])])))

;; The greatest monomial at the head of a bucket, #f when all are empty.
(define (greatest-monomial buckets used)
  (let loop ([i 0] [best #f])
    (cond [(eq? i used) best]
          [else
           (define b (vector-ref buckets i))
           (loop (fx+ i 1)
                 (if (and (pair? b)
                          (or (not best) (fx> (monomial-compare (leading-monomial b) best) 0)))
                     (leading-monomial b)
                     best))])))

;; The coefficient of m in the sum of the buckets; takes the terms with m off them.
(define (take-coefficient! buckets used m)
  (let loop ([i 0] [sum 0])
    (cond [(eq? i used) sum]
          [else
           (define b (vector-ref buckets i))
           (cond [(and (pair? b) (monomial=? (leading-monomial b) m))
                  (vector-set! buckets i (cdr b))
                  (loop (fx+ i 1) (+ sum (leading-coefficient b)))]
                 [else (loop (fx+ i 1) sum)])])))

;; -> the place where the polynomial went.
(define (put! R buckets i p)
  (define b (vector-ref buckets i))
  (cond [(null? b)
         (vector-set! buckets i p)
         i]
        [else
         (vector-set! buckets i '())
         (put! R buckets (fx+ i 1) (poly+ R b p))]))
