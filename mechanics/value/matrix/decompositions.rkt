#lang racket/base
;; Decompositions of a matrix: eigenvectors and singular values.

(require racket/flonum
         racket/list
         "eigenvalues.rkt" "exact-eigenvectors.rkt" "linear-algebra.rkt" "matrix.rkt"
         "numeric-eigenvectors.rkt"
         "../simplify.rkt" "../structure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/irrational.rkt"
         "../../generic/wrong-argument.rkt"
         (only-in "../../numeric/finite-number.rkt" exact-rational?)
         "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/linear-algebra/singular-values.rkt"
         "../../numeric/linear-algebra/symmetric-eigenvalues.rkt")

(provide eigenvectors svd)

;; ---------------------------------------------------------------------------
;; Eigenvectors

;; A list of (eigenvalue eigenvector ...), the vectors up tuples.
(define (eigenvectors m)
  (define rows (or (square-entries 'eigenvectors m) (raise-no-matrix 'eigenvectors m)))
  (cond [(all-entries? exact-rational? rows) (exact-eigenvectors (matrix rows))]
        [(not (inexact-entries? rows)) (vectors-of-null-spaces rows)]
        [(and (all-entries? real? rows) (symmetric? rows)) (vectors-of-symmetric rows)]
        [else (numeric-eigenvectors (rows-map exact->inexact rows))]))

(define (inexact-entries? rows)
  (and (all-entries? number? rows) (not (all-entries? exact? rows))))

;; The vectors that the matrix less the eigenvalue maps to 0.
(define (vectors-of-null-spaces rows)
  (define m (matrix rows))
  (for/list ([value (in-list (remove-duplicates (map simplify (eigenvalues m))))])
    (cons value (map simplify (null-space (simplify (g:- m value)))))))

(define (vectors-of-symmetric rows)
  (define-values (found vectors) (symmetric-eigenvalues (rows->flvector rows) (vector-length rows)))
  (for/list ([value (in-flvector found)] [v (in-list vectors)])
    (list value (apply up (flvector->list v)))))

;; ---------------------------------------------------------------------------
;; Singular values

;; (list U values V) with A = U Σ Vᵀ, the values falling, the columns of U and V of unit
;; length and orthogonal.
(define (svd A)
  (define rows
    (rows-map irrational-as-decimal
              (cond [(matrix? A) (matrix-rows A)]
                    [(tuple? A) (square-entries 'svd A)]
                    [else (raise-no-matrix 'svd A)])))
  (unless (all-entries? rational? rows)
    (complain-of-argument 'svd "a matrix of finite real numbers" A))
  (define wide? (> (row-length rows) (vector-length rows)))
  (define-values (us sizes vs)
    (singular-values (columns-of (if wide? (rows-transpose rows) rows))))
  (define-values (u v) (values (matrix-of-columns us) (matrix-of-columns vs)))
  (if wide? (list v sizes u) (list u sizes v)))

(define (matrix-of-columns columns) (apply matrix-by-columns (map flvector->list columns)))

(define (raise-no-matrix who m)
  (complain-of-argument who "a matrix or a tuple of tuples" m))
