#lang racket/base
;; Linear systems of bigfloats: elimination with partial pivoting.
;;
;; A pivot that is rounding beside its column is none: the matrix has no inverse then
;; that is known to any digit.

(require math/bigfloat
         "../linear/rows.rkt")

(provide solutions)

;; The rows of x with A x = right, in the precision in force; or 'singular.
(define (solutions A right)
  (define rows (beside A right))
  (define n (vector-length A))
  (define sizes (for/list ([j (in-range n)]) (column-size A j)))
  (let loop ([k 0] [sizes sizes])
    (cond [(= k n) (substitute-back rows n)]
          [else
           (define p (greatest-below rows k))
           (cond [(bf<= (bfabs (entry rows p k)) (rounding (car sizes) n)) 'singular]
                 [else (exchange! rows k p)
                       (clear-below! rows k)
                       (loop (+ k 1) (cdr sizes))])])))

(define (column-size A j)
  (for/fold ([size (bf 0)]) ([row (in-vector A)]) (bfmax size (bfabs (vector-ref row j)))))

(define (rounding size n) (bf* size (bf* (bf n) (bfshift (bf 1) (- (bf-precision))))))

(define (greatest-below rows k)
  (for/fold ([best k]) ([i (in-range (+ k 1) (vector-length rows))])
    (if (bf> (bfabs (entry rows i k)) (bfabs (entry rows best k))) i best)))

(define (clear-below! rows k)
  (define top (vector-ref rows k))
  (for ([i (in-range (+ k 1) (vector-length rows))])
    (define row (vector-ref rows i))
    (define factor (bf/ (vector-ref row k) (vector-ref top k)))
    (unless (bfzero? factor)
      (for ([l (in-range (+ k 1) (vector-length row))])
        (vector-set! row l (bf- (vector-ref row l) (bf* factor (vector-ref top l))))))))

(define (substitute-back rows n)
  (for ([i (in-range (- n 1) -1 -1)])
    (define row (vector-ref rows i))
    (for ([l (in-range n (vector-length row))])
      (define known
        (for/fold ([s (vector-ref row l)]) ([j (in-range (+ i 1) n)])
          (bf- s (bf* (vector-ref row j) (entry rows j l)))))
      (vector-set! row l (bf/ known (vector-ref row i)))))
  (for/vector #:length n ([row (in-vector rows)])
    (for/vector #:length (- (vector-length row) n) ([x (in-vector row n)]) x)))
