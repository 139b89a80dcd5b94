#lang racket/base
;; Determinants and systems in a ring: no division but one, by the determinant.
;;
;; Entries that are not numbers (expressions, dual numbers, functions) had better
;; not be divided by: a pivot may be zero in disguise.  Minors are the best means
;; while they take at most n⁴/2 products, which is up to n = 9 if no entry is zero
;; and any n for a band: nothing in them cancels, so that simplifying them is
;; cheap.  Beyond that a determinant in one or two symbols is eliminated as a
;; polynomial, and any other is the last coefficient of the characteristic
;; polynomial, in n⁴/4 products.

(require "../algebra.rkt" "../assumptions.rkt"
         "../../algebra/expression/expression.rkt"
         "../../algebra/elimination/minors.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/kind.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide ring-determinant ring-solutions
         generic-ring entry-columns zero-value?)

(define generic-ring (operations g:+ g:- g:*))

;; The columns of each row in which it has an entry.
(define (entry-columns rows)
  (for/vector #:length (vector-length rows) ([row (in-vector rows)])
    (for/list ([x (in-vector row)] [j (in-naturals)]
               #:unless (and (number? x) (zero? x)))
      j)))

;; Is x zero, even if it takes simplification to see?  Of a dual number it is the
;; number being varied that counts.
(define (zero-value? x)
  (define value (comparand x))
  (if (expression? value) (vanishes? value (assumptions-in-force)) (g:zero? value)))

;; ---------------------------------------------------------------------------
;; The choice

(define (few-minors? rows)
  (define n (vector-length rows))
  (or (< n 5)
      (expansion-cost (vector->list (entry-columns rows))
                      (min most-products (quotient (expt n 4) 2)))))

(define most-products 20000)

;; Determinants that can have no more terms than this are worth an elimination.
(define few-terms 200)

;; ---------------------------------------------------------------------------
;; Determinants

(define (ring-determinant rows)
  (define n (vector-length rows))
  (cond [(few-minors? rows) ((make-minors generic-ring rows) (all-lines n) (all-lines n))]
        [(and (all-entries? expression? rows)
              (eliminated-determinant rows few-terms (assumptions-in-force)))]
        [else (characteristic-determinant generic-ring rows)]))

;; ---------------------------------------------------------------------------
;; Systems

;; The rows of x with A · x = right; 'singular if A has no inverse.
(define (ring-solutions A right)
  (cond [(few-minors? A) (solutions-by-minors A right)]
        [(and (all-entries? expression? A right)
              (eliminated-solutions A right few-terms (assumptions-in-force)))]
        [else (solutions-by-powers A right)]))

;; Cramer's rule.
(define (solutions-by-minors A right)
  (define n (vector-length A))
  (define minor (make-minors generic-ring (beside A right)))
  (define d (minor (all-lines n) (all-lines n)))
  (define columns
    (for/vector ([column (in-vector (rows-transpose right))] [l (in-naturals n)])
      (for/vector #:length n ([j (in-range n)]) (Cramer-numerator minor n j column l))))
  (over-determinant columns d))

;; Of unknown j, for a right-hand side that is column l of the matrix; if that has
;; a single entry, a cofactor will do.
(define (Cramer-numerator minor n j column l)
  (define i (single-entry column))
  (if i
      (g:* (vector-ref column i) (cofactor generic-ring minor n i j))
      (minor-with-column generic-ring minor n j l)))

;; The place of the only entry; #f if there are more, or none.
(define (single-entry column)
  (define places (for/list ([x (in-vector column)] [i (in-naturals)] #:unless (eqv? x 0)) i))
  (and (pair? places) (null? (cdr places)) (car places)))

(define (solutions-by-powers A right)
  (define-values (d columns)
    (adjugate-times generic-ring A (vector->list (rows-transpose right))))
  (over-determinant (list->vector columns) d))

;; columns : of the unknowns times d
(define (over-determinant columns d)
  (if (zero-value? d)
      'singular
      (rows-transpose (rows-map (lambda (x) (g:/ x d)) columns))))
