#lang racket/base
;; Rotations of space as matrices (SICM 2.7, p. 139, and 2.12, p. 184).
;;
;; The rotation by θ about a unit vector n takes v to its part along n, unchanged, and turns
;; the rest (Rodrigues):
;;
;;     M = cos θ 1 + (1 − cos θ) n nᵀ + sin θ [n],       [n] v = n × v.
;;
;; A matrix is a rotation if Mᵀ M = 1 and det M = 1: where it is seen not to be one, it is refused
;; with the difference.

(require "three-vector.rkt"
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt" "../generic/tracing.rkt" "../generic/wrong-argument.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide rotate-x-matrix rotate-y-matrix rotate-z-matrix
         rotate-x-tuple rotate-y-tuple rotate-z-tuple
         angle-axis->rotation-matrix
         3vector-components->antisymmetric
         verify-rotation check-rotation check-unit check-3-by-3)

;; ---------------------------------------------------------------------------
;; About the axes

(define (rotate-x-matrix angle)
  (define-values (c s) (values (g:cos angle) (g:sin angle)))
  (matrix-by-rows (list 1 0 0)
                  (list 0 c (g:negate s))
                  (list 0 s c)))

(define (rotate-y-matrix angle)
  (define-values (c s) (values (g:cos angle) (g:sin angle)))
  (matrix-by-rows (list c 0 s)
                  (list 0 1 0)
                  (list (g:negate s) 0 c)))

(define (rotate-z-matrix angle)
  (define-values (c s) (values (g:cos angle) (g:sin angle)))
  (matrix-by-rows (list c (g:negate s) 0)
                  (list s c 0)
                  (list 0 0 1)))

;; The same as tuples, down of ups, which multiply an up tuple from the left.
(define (rotate-x-tuple angle) (as-tuple (rotate-x-matrix angle)))
(define (rotate-y-tuple angle) (as-tuple (rotate-y-matrix angle)))
(define (rotate-z-tuple angle) (as-tuple (rotate-z-matrix angle)))

(define (as-tuple M) (m->s (down 0 0 0) M (up 0 0 0)))

;; ---------------------------------------------------------------------------
;; About any axis

(define (angle-axis->rotation-matrix theta n)
  (define-values (x y z) (three 'angle-axis->rotation-matrix "the axis" n))
  (check-unit 'angle-axis->rotation-matrix "the axis" (up x y z))
  (define axis (up->column-matrix (up x y z)))
  (define c (g:cos theta))
  (g:+ (g:* c (identity-matrix 3))
       (g:* (g:- 1 c) (g:* axis (transpose axis)))
       (g:* (g:sin theta) (3vector-components->antisymmetric (up x y z)))))

;; The matrix that multiplies by v in the manner of a vector product.
(define (3vector-components->antisymmetric v)
  (define-values (x y z) (three '3vector-components->antisymmetric "a vector" v))
  (matrix-by-rows (list 0 (g:negate z) y)
                  (list z 0 (g:negate x))
                  (list (g:negate y) x 0)))

;; v : a tuple; of symbols it is taken for a unit vector
(define (check-unit who what v [tolerance tolerance])
  (define square (comparand (g:square v)))
  (when (and (real? square) (> (abs (- square 1)) tolerance))
    (complain who "~a is to have the length 1; given ~a\n  its length: ~a"
              what (describe-with-value v) (value->text (sqrt square)))))

;; ---------------------------------------------------------------------------
;; Is a matrix a rotation?

(define tolerance 1e-9)

(define (check-3-by-3 who M)
  (unless (matrix-of? M 3 3)
    (complain-of-argument who "a rotation, a 3 by 3 matrix" M)))

;; (up (Mᵀ M − 1) (det M − 1)), zero if M is a rotation
(define (shortfall M)
  (up (g:- (g:* (transpose M) M) (identity-matrix 3))
      (g:- (determinant M) 1)))

(define (verify-rotation M)
  (check-3-by-3 'verify-rotation M)
  (prove-zero (shortfall M)))

;; Refuses a matrix that can be seen not to be one.
(define (check-rotation who M)
  (check-3-by-3 who M)
  (define value (map-leaves comparand M))
  (unless (being-traced?)
    (cond [(all-entries? real? value) (check-numbers who value)]
          [(all-entries? expression? value) (check-expressions who value)])))

(define (all-entries? good? M)
  (for*/and ([i (in-range 3)] [j (in-range 3)]) (good? (matrix-ref M i j))))

(define (check-numbers who M)
  (define missed (shortfall M))
  (define most (for*/fold ([most (abs (ref missed 1))]) ([i (in-range 3)] [j (in-range 3)])
                 (max most (abs (matrix-ref (ref missed 0) i j)))))
  (unless (<= most tolerance) (refuse who M missed)))

(define (check-expressions who M)
  (define missed (shortfall M))
  (when (refuted? (prove-zero missed)) (refuse who M (simplify missed))))

(define (refuse who M missed)
  (if (g:zero? (ref missed 0))
      (complain who "the matrix reflects: its determinant is −1, that of a rotation 1\n  given: ~a"
                (value->text M))
      (complain who (string-append "the matrix is no rotation: its transpose times it is not 1"
                                   "\n  given: ~a\n  the product less 1: ~a")
                (value->text M) (value->text (ref missed 0)))))
