#lang racket/base
;; Sums and products of polynomials.
;;
;; Polynomials are lists of terms (term-list.rkt) with exact coefficients.  Sums
;; merge and share terms and tails with their operands.  A product is the sum
;; of shifted copies of one operand, added in a balanced tree; for the sizes
;; met here that costs no more than a heap or a hash table and allocates less
;; than either looks (5 to 15 ns a product of terms).

(require racket/fixnum
         "monomial.rkt" "ring.rkt" "term-list.rkt")

(provide
 poly-constant poly-variable
 poly+ poly- poly-negate poly* poly-scale poly-expt poly-sum
 shift-terms divide-by-monomial
 ;; for sums of other things
 define-sum sum-of-neighbours)

;; ---------------------------------------------------------------------------
;; Making

(define (poly-constant R c)
  (if (eqv? c 0) '() (list (make-term (ring-one R) c))))

(define (poly-variable R i [exponent 1])
  (list (make-term (variable-monomial R i exponent) 1)))

;; ---------------------------------------------------------------------------
;; Linear operations

;; (add p q extra ...) merges the terms of p and q; coefficients of one monomial are
;; added by (plus c d extra ...).
(define-syntax-rule (define-sum (add p q extra ...) plus)
  (define (add p q extra ...)
    (cond [(null? p) q]
          [(null? q) p]
          [else
           (define s (car p))
           (define t (car q))
           (define order (monomial-compare (term-monomial s) (term-monomial t)))
           (cond [(fx> order 0) (cons s (add (cdr p) q extra ...))]
                 [(fx< order 0) (cons t (add p (cdr q) extra ...))]
                 [else
                  (define c (plus (term-coefficient s) (term-coefficient t) extra ...))
                  (if (eq? c 0)
                      (add (cdr p) (cdr q) extra ...)
                      (cons (make-term (term-monomial s) c)
                            (add (cdr p) (cdr q) extra ...)))])])))

(define-sum (add p q) +)

(define (poly+ R p q) (add p q))
(define (poly- R p q) (add p (scale -1 q)))
(define (poly-negate R p) (scale -1 p))

(define (poly-scale R c p)
  (cond [(eqv? c 0) '()]
        [(eqv? c 1) p]
        [else (scale c p)]))

(define (scale c p)
  (if (null? p)
      '()
      (cons (make-term (leading-monomial p) (* c (leading-coefficient p))) (scale c (cdr p)))))

(define (poly-sum R ps) (sum-of-neighbours add ps '()))

;; The sum of a list by a procedure that adds two: first neighbours, then their sums.
(define (sum-of-neighbours add xs zero)
  (define (add-neighbours xs)
    (if (or (null? xs) (null? (cdr xs)))
        xs
        (cons (add (car xs) (cadr xs)) (add-neighbours (cddr xs)))))
  (cond [(null? xs) zero]
        [(null? (cdr xs)) (car xs)]
        [else (sum-of-neighbours add (add-neighbours xs) zero)]))

;; ---------------------------------------------------------------------------
;; Products

(define (poly* R p q)
  (cond [(or (null? p) (null? q)) '()]
        [else
         (check-monomial R (monomial+ (leading-monomial p) (leading-monomial q)))
         (define m (length p))
         (define n (length q))
         (charge! R (* m n (+ 1 (quotient (* (words-in p m) (words-in q n)) 16))))
         (if (<= m n) (multiply p m q) (multiply q n p))]))

;; How long the coefficients of p, of n terms, are: 0 for those of a machine word, and four
;; times the words of a fraction, which has to be reduced.
(define (words-in p n)
  (max (words (leading-coefficient p))
       (if (eqv? n 1) 0 (words (leading-coefficient (list-tail p (quotient n 2)))))))

(define (words c)
  (cond [(fixnum? c) 0]
        [(integer? c) (quotient (integer-length c) 64)]
        [else
         (* 4 (quotient (+ (integer-length (numerator c)) (integer-length (denominator c))) 64))]))

;; p of n terms, times q.
(define (multiply p n q)
  (define-values (product rest)
    (let loop ([p p] [n n])
      (cond [(eq? n 1)
             (values (shift-terms (leading-monomial p) (leading-coefficient p) q) (cdr p))]
            [else
             (define half (quotient n 2))
             (define-values (left middle) (loop p half))
             (define-values (right rest) (loop middle (- n half)))
             (values (add left right) rest)])))
  product)

;; The terms of q times the term of m and c.
(define (shift-terms m c q)
  (cond [(not (eqv? c 1)) (shift-scale m c q)]
        [(monomial-one? m) q]
        [else (shift m q)]))

(define (shift-scale m c q)
  (if (null? q)
      '()
      (cons (make-term (monomial+ m (leading-monomial q)) (* c (leading-coefficient q)))
            (shift-scale m c (cdr q)))))

(define (shift m q)
  (if (null? q)
      '()
      (cons (make-term (monomial+ m (leading-monomial q)) (leading-coefficient q))
            (shift m (cdr q)))))

;; p over a monomial that divides it.
(define (divide-by-monomial R p m)
  (shift-terms (monomial- (ring-one R) m) 1 p))

;; k a natural number.  Multiplying by p again and again is quicker for sparse
;; polynomials than squaring.
(define (poly-expt R p k)
  (cond [(eqv? k 0) (poly-constant R 1)]
        [(null? p) '()]
        [(single-term? p)
         (list (make-term (check-power R (leading-monomial p) k)
                          (expt (leading-coefficient p) k)))]
        [else
         (check-power R (leading-monomial p) k)
         (for/fold ([power p]) ([i (in-range 1 k)]) (poly* R p power))]))
