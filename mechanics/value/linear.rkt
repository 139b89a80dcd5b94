#lang racket/base
;; Linear algebra on matrices and on structures that stand for linear maps.
;;
;; A tuple of tuples A is a linear map by the product (* A x); contraction runs
;; over the outer index, so that the components of A are the columns of its
;; matrix when A is seen as acting on tuples x (SICM p. 516 and 5.2.2).

(require "structure.rkt" "matrix.rkt" "linear-algebra.rkt"
         (only-in "signature.rkt" scalar?)
         "../generic/kind.rkt" "../generic/structure.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/dispatch.rkt" "../generic/arithmetic.rkt")

(provide transpose determinant trace
         solve-linear-left solve-linear-right
         s->m m->s s:inverse)

;; ---------------------------------------------------------------------------
;; Square things

(define (determinant m)
  (cond [(matrix? m) (rows-determinant (square-rows 'determinant m))]
        [(tuple? m) (rows-determinant (tuple-rows 'determinant m))]
        [else (of-scalar-or-function generic:determinant m)]))

(define (trace m)
  (cond [(matrix? m) (diagonal-sum (square-rows 'trace m))]
        [(tuple? m) (diagonal-sum (tuple-rows 'trace m))]
        [else (of-scalar-or-function generic:trace m)]))

(define (diagonal-sum rows)
  (for/fold ([sum 0]) ([row (in-vector rows)] [i (in-naturals)])
    (g:+ sum (vector-ref row i))))

;; A scalar is a matrix of one entry; a function is taken by its values.
(define (of-scalar-or-function op x)
  (cond [(scalar? x) x]
        [(pointwise? x) (compose-unary op x)]
        [else (raise-inapplicable op x)]))

(define (generic-of-matrices name procedure) (generic-op name #f procedure '()))
(define generic:determinant (generic-of-matrices 'determinant determinant))
(define generic:trace (generic-of-matrices 'trace trace))

;; The components of a square tuple of tuples, each a vector.
(define (tuple-rows who s)
  (define rows (component-vectors who s))
  (unless (for/and ([row (in-vector rows)]) (= (vector-length row) (vector-length rows)))
    (raise-arguments-error who "expected as many components in each component as there are components"
                           "structure" s))
  rows)

(define (component-vectors who s)
  (for/vector ([x (in-vector (structure-elements (structure-of who s)))])
    (unless (tuple? x)
      (raise
       (exn:fail:contract
        (format "~a: expected a tuple of tuples; given ~a" who (describe-with-value s))
        (current-continuation-marks))))
    (structure-elements (adopt x))))

;; ---------------------------------------------------------------------------
;; Transposition

;; Of a matrix; of a tuple of tuples, whose two orientations exchange places
;; with their indices; and, with a typical right multiplicand rs, of a structure
;; ms seen as the matrix of rs ↦ (* ms rs) (SICM p. 351).
(define transpose
  (case-lambda
    [(m)
     (cond [(matrix? m) (matrix (rows-transpose (matrix-rows m)))]
           [(tuple? m) (transpose-tuple (adopt m))]
           [else (of-scalar-or-function generic:transpose m)])]
    [(ms rs)
     (define ls (compatible-shape (g:* ms rs)))
     (m->s rs (transpose (s->m ls ms rs)) ls)]))

(define generic:transpose (generic-of-matrices 'transpose (lambda (m) (transpose m))))

(define (transpose-tuple s)
  (define rows (component-vectors 'transpose s))
  (define inner (structure-orientation (structure-of 'transpose (s:ref s 0))))
  (structure inner
             (for/vector ([row (in-vector (rows-transpose rows))])
               (same-orientation s row))))

;; ---------------------------------------------------------------------------
;; Linear systems

;; x such that (* A x) is b.
(define (solve-linear-left A b)
  (cond [(matrix? A)
         (define x (rows-solve 'solve-linear-left (square-rows 'solve-linear-left A)
                               (right-hand-side 'solve-linear-left A b)))
         (if (matrix? b) (up->column-matrix (structure 'up x)) (structure 'up x))]
        [(tuple? A) (solve-by-outer-index 'solve-linear-left (adopt A) b)]
        [else (g:/ b A)]))

;; x such that (* x A) is b.
(define (solve-linear-right b A)
  (cond [(matrix? A)
         (structure 'down (rows-solve 'solve-linear-right
                                      (rows-transpose (square-rows 'solve-linear-right A))
                                      (right-hand-side 'solve-linear-right A b)))]
        [(tuple? A)
         (define inner (structure-of 'solve-linear-right (s:ref A 0)))
         (if (eq? (structure-orientation inner) (structure-orientation (adopt A)))
             (solve-by-outer-index 'solve-linear-right (adopt A) b)
             (solve-by-inner-index 'solve-linear-right (adopt A) inner b))]
        [else (g:/ b A)]))

(define (right-hand-side who A b)
  (define v
    (cond [(matrix? b) (structure-elements (if (= 1 (m:num-cols b)) (m:nth-col b 0) (m:nth-row b 0)))]
          [(tuple? b) (structure-elements (adopt b))]
          [else (raise-argument-error who "a tuple or a matrix of one row or column" b)]))
  (unless (= (vector-length v) (m:num-rows A))
    (raise-arguments-error who "the matrix and the right-hand side differ in size"
                           "matrix" A "right-hand side" b))
  v)

;; Σᵢ xᵢ Aᵢ = b, the x of orientation opposite to A's.
(define (solve-by-outer-index who A b)
  (define rows (tuple-rows who A))
  (structure (flip-orientation (structure-orientation A))
             (rows-solve who (rows-transpose rows) (matching who A (s:ref A 0) b))))

;; Σⱼ Aᵢⱼ xⱼ = bᵢ, the x of orientation opposite to that of A's components.
(define (solve-by-inner-index who A inner b)
  (structure (flip-orientation (structure-orientation inner))
             (rows-solve who (tuple-rows who A) (matching who A A b))))

;; The components of b, which must be of the shape of `like`.
(define (matching who A like b)
  (unless (and (tuple? b) (compatible? (adopt b) (adopt like)))
    (raise
     (exn:fail:contract
      (format "~a: the right-hand side must be ~a, to match ~a; given ~a"
              who (describe (adopt like)) (value->text A) (describe-with-value b))
      (current-continuation-marks))))
  (structure-elements (adopt b)))

;; ---------------------------------------------------------------------------
;; Structures as matrices (SICM p. 353)

;; The matrix of the bilinear form (* ls (* ms rs)) in the scalars of ls and rs.
(define (s->m ls ms rs)
  (define lefts (units ls))
  (define rights (units rs))
  (matrix
   (for/vector ([l (in-list lefts)])
     (for/vector ([r (in-list rights)])
       (g:* l (g:* ms r))))))

;; The structure whose bilinear form on ls and rs has this matrix.
(define (m->s ls m rs)
  (define j -1)
  (s:map/r (lambda (_)
             (set! j (add1 j))
             (define column j)
             (define i -1)
             (s:map/r (lambda (_) (set! i (add1 i)) (matrix-ref m i column)) (flip ls)))
           (flip rs)))

;; The structures like s with one scalar 1 and all others 0, in order.
(define (units s)
  (for/list ([k (in-range (s:dimension s))])
    (define n -1)
    (s:map/r (lambda (_) (set! n (add1 n)) (if (= n k) 1 0)) s)))

;; The structure undoing rs ↦ (* ms rs).
(define (s:inverse ls ms rs)
  (m->s (flip rs) (m:invert (s->m ls ms rs)) (flip ls)))
