#lang racket/base
;; Determinants and linear systems over the generic arithmetic.
;;
;; A matrix here is a vector of rows.  Its zeros are looked at first: it falls
;; into blocks (algebra/linear/pattern.rkt), each treated by itself:
;;
;; - exact numbers: elimination without fractions;
;; - numbers, some of them flonums: elimination with partial pivoting;
;; - anything else: without divisions, one by the determinant apart.  Minors are
;;   best while they take at most n⁴/2 products, which is up to n = 9 if no entry is
;;   zero and any n for a band: nothing in them cancels, so that simplifying them
;;   is cheap.  Beyond that, a determinant in one or two symbols is eliminated as a
;;   polynomial, and any other is the last coefficient of the characteristic
;;   polynomial, in n⁴/4 products.
;;
;; Results are graphs that share what they are made of, not simplified.

(require "singular.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/kind.rkt"
         "../generic/structure.rkt"
         "../algebra/expression.rkt" "../algebra/vanishing.rkt"
         "../algebra/linear/characteristic.rkt" "../algebra/linear/coefficients.rkt"
         "../algebra/linear/elimination.rkt" "../algebra/linear/minors.rkt"
         "../algebra/linear/pattern.rkt"
         "../numeric/linear-systems.rkt")

(provide rows-determinant rows-solve rows-solve-each rows-inverse rows-transpose
         rows-rank rows-null-space rows-characteristic rows-diagonal-blocks)

(define generic (operations g:+ g:- g:*))

;; ---------------------------------------------------------------------------
;; Rows

(define (entry rows i j) (vector-ref (vector-ref rows i) j))

(define (zero-entry? x) (and (number? x) (zero? x)))

(define (all-entries? good? rows)
  (for*/and ([row (in-vector rows)] [x (in-vector row)]) (good? x)))

(define (rows-transpose rows)
  (define n (if (zero? (vector-length rows)) 0 (vector-length (vector-ref rows 0))))
  (for/vector #:length n ([j (in-range n)])
    (for/vector #:length (vector-length rows) ([row (in-vector rows)])
      (vector-ref row j))))

;; The columns of each row in which it has an entry.
(define (entry-columns rows)
  (for/vector #:length (vector-length rows) ([row (in-vector rows)])
    (for/list ([x (in-vector row)] [j (in-naturals)] #:unless (zero-entry? x)) j)))

(define (submatrix rows is js)
  (for/vector #:length (length is) ([i (in-list is)])
    (for/vector #:length (length js) ([j (in-list js)]) (entry rows i j))))

(define (unit-rows n)
  (build-vector n (lambda (i) (build-vector n (lambda (j) (if (= i j) 1 0))))))

;; ---------------------------------------------------------------------------
;; Determinants

(define (rows-determinant rows)
  (define form (block-triangular-form (entry-columns rows)))
  (cond [(deficiency? form) (if (and (all-entries? number? rows) (not (exact-numbers? rows))) 0.0 0)]
        [else
         (define sign (* (permutation-sign (append-map block-rows form))
                         (permutation-sign (append-map block-columns form))))
         (for/fold ([product sign]) ([b (in-list form)])
           (g:* product (block-determinant (submatrix rows (block-rows b) (block-columns b)))))]))

(define (append-map f xs) (apply append (map f xs)))

(define (block-determinant rows)
  (cond [(exact-numbers? rows) (eliminated-determinant rows 1)]
        [(all-entries? number? rows) (floating-determinant rows)]
        [else (determinant-in-ring rows)]))

(define (determinant-in-ring rows)
  (define n (vector-length rows))
  (cond [(few-minors? rows) ((make-minors generic rows) (all-lines n) (all-lines n))]
        [(and (all-entries? expression? rows) (eliminated-determinant rows few-terms))]
        [else (characteristic-determinant generic rows)]))

(define (few-minors? rows)
  (define n (vector-length rows))
  (or (< n 5)
      (expansion-cost (vector->list (entry-columns rows)) (quotient (expt n 4) 2))))

;; Determinants that can have no more terms than this are worth an elimination.
(define few-terms 200)

;; ---------------------------------------------------------------------------
;; Systems

;; The vector x with rows · x = b.  For the failure: who asked, what the matrix was
;; given as, and what is made of the components of an unknown.
(define (rows-solve who given rows b [shape up])
  (define right (for/vector #:length (vector-length b) ([x (in-vector b)]) (vector x)))
  (for/vector #:length (vector-length rows)
              ([row (in-vector (solve (failure who given rows right shape) rows right))])
    (vector-ref row 0)))

;; The solutions for several right-hand sides, a vector of vectors.
(define (rows-solve-each who given rows bs [shape up])
  (define right (rows-transpose bs))
  (rows-transpose (solve (failure who given rows right shape) rows right)))

(define (rows-inverse who given rows)
  (solve (failure who given rows #f up) rows (unit-rows (vector-length rows))))

(define (up components) (structure 'up components))

(define ((failure who given rows right shape))
  (raise-singular-matrix who given rows right shape))

;; The rows of x with rows · x = right, block after block: what a block needs of
;; others is known then.
(define (solve fail rows right)
  (define form (block-triangular-form (entry-columns rows)))
  (when (deficiency? form) (fail))
  (define x (make-vector (vector-length rows) #f))
  (for ([b (in-list form)])
    (define A (submatrix rows (block-rows b) (block-columns b)))
    (define y (block-solutions A (remaining-right rows right x (block-rows b))))
    (when (eq? y 'singular) (fail))
    (for ([j (in-list (block-columns b))] [row (in-vector y)]) (vector-set! x j row)))
  x)

;; The right-hand sides of rows `is` without the terms of unknowns already known.
(define (remaining-right rows right x is)
  (for/vector #:length (length is) ([i (in-list is)])
    (for/fold ([r (vector-ref right i)])
              ([a (in-vector (vector-ref rows i))] [y (in-vector x)] #:when y
                                                   #:unless (zero-entry? a))
      (for/vector #:length (vector-length r) ([b (in-vector r)] [z (in-vector y)])
        (if (eqv? z 0) b (g:- b (g:* a z)))))))

;; -> rows, or 'singular
(define (block-solutions A right)
  (define n (vector-length A))
  (cond [(= n 1) (solve-one (entry A 0 0) (vector-ref right 0))]
        [(not (all-entries? number? A)) (solutions-in-ring A right)]
        [(all-entries? number? right) (numeric-solutions A right)]
        [else
         (define inverse (numeric-solutions A (unit-rows n)))
         (if (eq? inverse 'singular) inverse (rows-product inverse right))]))

(define (solve-one a right)
  (if (zero-determinant? a)
      'singular
      (vector (for/vector #:length (vector-length right) ([b (in-vector right)]) (g:/ b a)))))

(define (numeric-solutions A right)
  (if (and (exact-numbers? A) (exact-numbers? right))
      (eliminated-solutions A right 1)
      (floating-solutions A right)))

(define (rows-product a b)
  (define columns (rows-transpose b))
  (for/vector #:length (vector-length a) ([row (in-vector a)])
    (for/vector #:length (vector-length columns) ([column (in-vector columns)])
      (dot row column))))

(define (dot v w)
  (for/fold ([sum 0]) ([x (in-vector v)] [y (in-vector w)] #:unless (or (eqv? x 0) (eqv? y 0)))
    (g:+ sum (g:* x y))))

;; ---------------------------------------------------------------------------
;; Systems without divisions but by the determinant

(define (solutions-in-ring A right)
  (cond [(few-minors? A) (solutions-by-minors A right)]
        [(and (all-entries? expression? A) (all-entries? expression? right)
              (eliminated-solutions A right few-terms))]
        [else (solutions-by-powers A right)]))

;; Cramer's rule.
(define (solutions-by-minors A right)
  (define n (vector-length A))
  (define minor (make-minors generic (beside A right)))
  (define d (minor (all-lines n) (all-lines n)))
  (define solution (solution-over-determinant minor n right))
  (if (zero-determinant? d)
      'singular
      (for/vector #:length n ([j (in-range n)])
        (for/vector #:length (vector-length (vector-ref right 0))
                    ([l (in-range (vector-length (vector-ref right 0)))])
          (g:/ (solution j l) d)))))

;; -> (j l -> unknown j for right-hand side l, times the determinant)
(define (solution-over-determinant minor n right)
  (define singles (map single-entry (vector->list (rows-transpose right))))
  (lambda (j l)
    (define i (list-ref singles l))
    (if i
        (g:* (entry right i l) (cofactor generic minor n i j))
        (minor-with-column generic minor n j (+ n l)))))

;; The place of the only entry of a column; #f if there are more.
(define (single-entry column)
  (define places (for/list ([x (in-vector column)] [i (in-naturals)] #:unless (eqv? x 0)) i))
  (cond [(null? places) 0]
        [(null? (cdr places)) (car places)]
        [else #f]))

(define (beside a b)
  (for/vector #:length (vector-length a) ([r (in-vector a)] [s (in-vector b)])
    (list->vector (append (vector->list r) (vector->list s)))))

(define (solutions-by-powers A right)
  (define-values (d columns)
    (adjugate-times generic A (vector->list (rows-transpose right))))
  (if (zero-determinant? d)
      'singular
      (for/vector #:length (vector-length A) ([row (in-vector (rows-transpose (list->vector columns)))])
        (for/vector #:length (vector-length row) ([x (in-vector row)]) (g:/ x d)))))

;; A value that is zero, even if it takes simplification to see; of a dual number,
;; the number that is varied.
(define (zero-determinant? d)
  (define look (and (has-kind? d) (kind-comparand (kind-of d))))
  (cond [look (zero-determinant? (look d))]
        [(expression? d) (vanishes? d)]
        [else (g:zero? d)]))

;; ---------------------------------------------------------------------------
;; Rank and null space, of numbers and expressions in any number of rows

(define (rows-rank who given rows)
  (kernel-basis-rank (kernel-of who given rows)))

;; A list of vectors.
(define (rows-null-space who given rows)
  (kernel-basis-vectors (kernel-of who given rows)))

(define (kernel-of who given rows)
  (unless (all-entries? expression? rows) (raise-no-scalars who given))
  (or (matrix-kernel rows) (raise-too-large who given)))

;; ---------------------------------------------------------------------------
;; Characteristic polynomials

;; (1 p₁ ... pₙ) with |x - rows| = xⁿ + p₁ xⁿ⁻¹ + ... + pₙ.
(define (rows-characteristic rows) (characteristic-coefficients generic rows))

;; Square matrices on the diagonal, as small as its zeros allow, that have the
;; eigenvalues of this one among them.
(define (rows-diagonal-blocks rows)
  (for/list ([is (in-list (strong-components
                           (for/vector ([js (in-vector (entry-columns rows))] [i (in-naturals)])
                             (for/list ([j (in-list js)] #:unless (= i j)) j))))])
    (submatrix rows is is)))
