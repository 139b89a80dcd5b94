#lang racket/base
;; Sums and products of polynomials.
;;
;; A polynomial is the list of its terms (monomial . coefficient), by strictly
;; decreasing monomial, with exact nonzero coefficients; zero is '().  Sums
;; merge and share terms and tails with their operands.  A product is the sum
;; of shifted copies of one operand, added in a balanced tree; for the sizes
;; met here that costs no more than a heap or a hash table and allocates less
;; than either looks (5 to 15 ns a product of terms).

(require racket/fixnum "monomial.rkt" "ring.rkt")

(provide
 poly-constant poly-variable poly-monomial
 poly+ poly- poly-negate poly* poly-scale poly-expt poly-sum
 shift-terms)

;; ---------------------------------------------------------------------------
;; Making

(define (poly-constant R c)
  (if (eqv? c 0) '() (list (cons (ring-one R) c))))

(define (poly-variable R i [exponent 1])
  (list (cons (variable-monomial R i exponent) 1)))

(define (poly-monomial R coefficient exponents)
  (if (eqv? coefficient 0)
      '()
      (list (cons (exponents->monomial R exponents) coefficient))))

;; ---------------------------------------------------------------------------
;; Linear operations

(define (poly+ R p q) (add p q))

(define (add p q)
  (cond [(null? p) q]
        [(null? q) p]
        [else
         (define s (car p))
         (define t (car q))
         (define order (monomial-compare (car s) (car t)))
         (cond [(fx> order 0) (cons s (add (cdr p) q))]
               [(fx< order 0) (cons t (add p (cdr q)))]
               [else
                (define c (+ (cdr s) (cdr t)))
                (if (eq? c 0)
                    (add (cdr p) (cdr q))
                    (cons (cons (car s) c) (add (cdr p) (cdr q))))])]))

(define (poly- R p q) (subtract p q))

(define (subtract p q)
  (cond [(null? p) (negate q)]
        [(null? q) p]
        [else
         (define s (car p))
         (define t (car q))
         (define order (monomial-compare (car s) (car t)))
         (cond [(fx> order 0) (cons s (subtract (cdr p) q))]
               [(fx< order 0) (cons (cons (car t) (- (cdr t))) (subtract p (cdr q)))]
               [else
                (define c (- (cdr s) (cdr t)))
                (if (eq? c 0)
                    (subtract (cdr p) (cdr q))
                    (cons (cons (car s) c) (subtract (cdr p) (cdr q))))])]))

(define (poly-negate R p) (negate p))

(define (negate p)
  (if (null? p)
      '()
      (cons (cons (caar p) (- (cdar p))) (negate (cdr p)))))

(define (poly-scale R c p)
  (cond [(eqv? c 0) '()]
        [(eqv? c 1) p]
        [else (scale c p)]))

(define (scale c p)
  (if (null? p)
      '()
      (cons (cons (caar p) (* c (cdar p))) (scale c (cdr p)))))

;; The sum of a list, neighbours first.
(define (poly-sum R ps)
  (cond [(null? ps) '()]
        [(null? (cdr ps)) (car ps)]
        [else (poly-sum R (add-neighbours ps))]))

(define (add-neighbours ps)
  (cond [(null? ps) '()]
        [(null? (cdr ps)) ps]
        [else (cons (add (car ps) (cadr ps)) (add-neighbours (cddr ps)))]))

;; ---------------------------------------------------------------------------
;; Products

(define (poly* R p q)
  (cond [(or (null? p) (null? q)) '()]
        [else
         (check-monomial R (monomial+ (caar p) (caar q)))
         (define m (length p))
         (define n (length q))
         (charge! R (fx* m n))
         (if (<= m n) (multiply p m q) (multiply q n p))]))

;; p of n terms, times q.
(define (multiply p n q)
  (define-values (product rest)
    (let loop ([p p] [n n])
      (cond [(eq? n 1) (values (shift-terms (caar p) (cdar p) q) (cdr p))]
            [else
             (define half (quotient n 2))
             (define-values (left middle) (loop p half))
             (define-values (right rest) (loop middle (- n half)))
             (values (add left right) rest)])))
  product)

;; The terms of q times the term (m . c).
(define (shift-terms m c q)
  (cond [(not (eqv? c 1)) (shift-scale m c q)]
        [(monomial-one? m) q]
        [else (shift m q)]))

(define (shift-scale m c q)
  (if (null? q)
      '()
      (cons (cons (monomial+ m (caar q)) (* c (cdar q))) (shift-scale m c (cdr q)))))

(define (shift m q)
  (if (null? q)
      '()
      (cons (cons (monomial+ m (caar q)) (cdar q)) (shift m (cdr q)))))

;; k a natural number.  Multiplying by p again and again is quicker for sparse
;; polynomials than squaring.
(define (poly-expt R p k)
  (cond [(eqv? k 0) (poly-constant R 1)]
        [(null? p) '()]
        [(null? (cdr p))
         (list (cons (check-power R (caar p) k) (expt (cdar p) k)))]
        [else
         (check-power R (caar p) k)
         (for/fold ([power p]) ([i (in-range 1 k)]) (poly* R p power))]))
