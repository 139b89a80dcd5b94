#lang racket/base
;; Determinants and linear systems over the generic arithmetic.
;;
;; A matrix here is a vector of rows.  Its zeros are looked at first: it falls
;; into blocks (algebra/elimination/block-form.rkt), each treated by itself:
;;
;; - exact numbers by elimination without fractions (algebra/elimination/bareiss.rkt),
;; - numbers, some of them flonums, with partial pivoting
;; (numeric/linear-algebra/flonum-systems.rkt),
;; - those of higher precision likewise (numeric/bigfloat/bigfloat-systems.rkt),
;; - perturbed values by systems of their parts (perturbed-system.rkt),
;; - anything else without divisions (division-free.rkt).
;;
;; Results are graphs that share their parts, not simplified.

(require racket/list
         "division-free.rkt" "perturbed-system.rkt" "row-products.rkt" "traced-linear-system.rkt"
         "singular-matrix.rkt"
         "../algebra.rkt"
         "../../algebra/expression/expression.rkt"
         "../../algebra/elimination/block-form.rkt"
         "../../generic/arithmetic.rkt" "../../generic/on-demand.rkt" "../../generic/scalar.rkt"
         "../../generic/irrational.rkt" "../../generic/up-down.rkt"
         "../../numeric/linear-algebra/flonum-systems.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide rows-determinant rows-solve rows-solve-each rows-inverse
         rows-rank rows-null-space rows-characteristic rows-diagonal-blocks
         rows-transpose)

(require-on-demand ["../bigfloat.rkt" bigfloat-solutions])

;; ---------------------------------------------------------------------------
;; Determinants

(define (rows-determinant rows)
  (define form (block-triangular-form (entry-columns rows)))
  (cond [(deficiency? form) (if (flonums? rows) 0.0 0)]
        [else
         (define sign (* (permutation-sign (append-map block-rows form))
                         (permutation-sign (append-map block-columns form))))
         (for/fold ([product sign]) ([b (in-list form)])
           (g:* product
                (block-determinant (submatrix rows (block-rows b) (block-columns b)))))]))

(define (flonums? rows) (and (all-entries? number? rows) (not (exact-numbers? rows))))

(define (block-determinant given)
  (define rows (with-one-precision given))
  (cond [(exact-numbers? rows) (eliminated-determinant rows 1)]
        [(all-entries? number? rows) (floating-determinant rows)]
        [else (or (and (many-rows? rows) (pivots-determinant rows)) (ring-determinant rows))]))

;; ---------------------------------------------------------------------------
;; Systems

;; The vector x with rows · x = b.  For the message of a failure: who asked, the matrix as it was
;; given, and the shape that a procedure gives to the components of an unknown.
(define (rows-solve who given rows b [shape up-of])
  (vector-ref (rows-solve-each who given rows (vector b) shape) 0))

;; The solutions for several right-hand sides, a vector of vectors.
(define (rows-solve-each who given rows bs [shape up-of])
  (define right (rows-transpose bs))
  (rows-transpose (solve (failure who given rows right shape) rows right)))

(define (rows-inverse who given rows)
  (solve (failure who given rows #f up-of) rows (unit-rows (vector-length rows))))

(define ((failure who given rows right shape))
  (raise-singular-matrix who given rows right shape))

;; The rows of x with rows · x = right, block after block: each needs only unknowns of blocks
;; before it.
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
                                                   #:unless (eqv? a 0))
      (for/vector #:length (vector-length r) ([b (in-vector r)] [z (in-vector y)])
        (if (eqv? z 0) b (g:- b (g:* a z)))))))

;; -> rows, or 'singular
(define (block-solutions left constant)
  (define A (with-one-precision left constant))
  (define right (with-one-precision constant left))
  (define n (vector-length A))
  (cond [(= n 1) (solve-one (entry A 0 0) (vector-ref right 0))]
        [(open-system? A right) (open-solutions A right)]
        [(perturbed-system? A right) (perturbed-solutions block-solutions A right)]
        [(other-numbers? A right) (bigfloat-solutions A right)]
        [(not (all-entries? number? A)) (ring-solutions A right)]
        [(all-entries? number? right) (numeric-solutions A right)]
        [else
         (define inverse (numeric-solutions A (unit-rows n)))
         (if (eq? inverse 'singular) inverse (rows-product inverse right))]))

;; Numbers, some of them of higher precision?
(define (other-numbers? A right)
  (and (all-entries? plain-number? A right)
       (not (all-entries? (lambda (x) (or (number? x) (irrational? x))) A right))))

;; Beside flonums irrational numbers are decimals.
(define (with-one-precision rows . others)
  (if (apply all-entries? (lambda (x) (not (flonum? x))) rows others)
      rows
      (rows-map irrational-as-decimal rows)))

(define (solve-one a right)
  (if (zero-value? a)
      'singular
      (vector (for/vector #:length (vector-length right) ([b (in-vector right)]) (g:/ b a)))))

(define (numeric-solutions A right)
  (if (and (exact-numbers? A) (exact-numbers? right))
      (eliminated-solutions A right 1)
      (floating-solutions A right)))

;; ---------------------------------------------------------------------------
;; Rank and null space, of numbers and expressions in any number of rows

(define (rows-rank who given rows)
  (kernel-basis-rank (kernel-of who given rows)))

;; A list of vectors.
(define (rows-null-space who given rows)
  (kernel-basis-vectors (kernel-of who given rows)))

(define (kernel-of who given rows)
  (define entries (rows-map irrational-as-expression (with-one-precision rows)))
  (unless (all-entries? expression? entries) (raise-no-scalars who given))
  (or (matrix-kernel entries) (raise-too-large who given)))

;; ---------------------------------------------------------------------------
;; Characteristic polynomials

;; (1 p₁ ... pₙ) with |x - rows| = xⁿ + p₁ xⁿ⁻¹ + ... + pₙ.
(define (rows-characteristic rows) (characteristic-coefficients generic-ring rows))

;; Square matrices on the diagonal, as small as its zeros allow, that have the
;; eigenvalues of this one among them.
(define (rows-diagonal-blocks rows)
  (define successors
    (for/vector ([js (in-vector (entry-columns rows))] [i (in-naturals)])
      (for/list ([j (in-list js)] #:unless (= i j)) j)))
  (for/list ([is (in-list (strong-components successors))])
    (submatrix rows is is)))
