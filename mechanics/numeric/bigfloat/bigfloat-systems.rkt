#lang racket/base
;; Linear systems of bigfloats: elimination with partial pivoting.
;;
;; A pivot that is rounding beside its column is none: the matrix has no inverse then
;; that is known to any digit.

(require math/bigfloat
         "../linear-algebra/row-operations.rkt" "../linear-algebra/row-matrix.rkt")

(provide solutions)

(define-row-operations (greatest-below clear-below! substitute-back!)
  0.bf bfzero? bf- bf* bf/ bfabs bf>)

;; The rows of x with A x = right, in the precision in force; or 'singular.
(define (solutions A right)
  (define rows (beside A right))
  (define n (vector-length A))
  (define sizes (for/list ([j (in-range n)]) (column-size A j)))
  (let loop ([k 0] [sizes sizes])
    (cond [(= k n) (substitute-back! rows)]
          [else
           (define p (greatest-below rows k))
           (cond [(bf<= (bfabs (entry rows p k)) (rounding (car sizes) n)) 'singular]
                 [else (exchange! rows k p)
                       (clear-below! rows k k (+ k 1))
                       (loop (+ k 1) (cdr sizes))])])))

(define (column-size A j)
  (for/fold ([size (bf 0)]) ([row (in-vector A)]) (bfmax size (bfabs (vector-ref row j)))))

(define (rounding size n) (bf* size (bf* (bf n) (bfshift (bf 1) (- (bf-precision))))))
