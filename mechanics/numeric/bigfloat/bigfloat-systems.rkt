#lang racket/base
;; Linear systems of bigfloats: elimination with partial pivoting.
;;
;; A pivot that is rounding beside its column is none: the matrix has no inverse then
;; that is known to any digit.

(require math/bigfloat
         "../linear-algebra/row-operations.rkt" "../linear-algebra/row-matrix.rkt")

(provide solutions)

(define-row-operations (triangulate! clear-below! substitute-back!)
  0.bf bfzero? bf- bf* bf/ bfabs bf>)

;; The rows of x with A x = right, in the precision in force; or 'singular.
(define (solutions A right)
  (define rows (beside A right))
  (define n (vector-length A))
  (define sizes (for/vector ([j (in-range n)]) (column-size A j)))
  (define (too-small? pivot k) (bf<= (bfabs pivot) (rounding (vector-ref sizes k) n)))
  (if (triangulate! rows too-small?) (substitute-back! rows) 'singular))

(define (column-size A j)
  (for/fold ([size (bf 0)]) ([row (in-vector A)]) (bfmax size (bfabs (vector-ref row j)))))

(define (rounding size n) (bf* size (bf* (bf n) (bfshift (bf 1) (- (bf-precision))))))
