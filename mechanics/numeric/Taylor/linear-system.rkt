#lang racket/base
;; Linear systems along a motion: A x = b, where the coefficients of A and b are known.
;;
;; Order 0 is solved as any system; A₀ stays factored.  Then
;;
;;     A₀ x_k = b_k − Σ A_j x_{k−j}, j from 1.

(require racket/fixnum
         racket/flonum
         "../linear-algebra/factored-system.rkt" "../unboxed-loop.rkt"
         "convolution.rkt")

(provide system)

;; A : vector of n² rows of coefficients, row by row; varying : vector, does one of them vary?
;; b, x : vectors of n rows
;; -> kernel, for all orders
(define (system A varying b x)
  (define n (vector-length b))
  (define factors (make-flvector (* n n)))
  (define exchanges (make-fxvector n))
  (define right (make-flvector n))
  (define changing                      ; of each row of A, the columns that vary
    (for/vector #:length n ([i (in-range n)])
      (for/list ([j (in-range n)] #:when (vector-ref varying (+ (* i n) j))) j)))
  (define (store! k)
    (solve-factored! factors n exchanges right)
    (for ([row (in-vector x)] [value (in-flvector right)]) (put! row k value)))
  (define (start!)
    (for ([row (in-vector A)] [i (in-naturals)]) (flvector-set! factors i (at row 0)))
    (for ([row (in-vector b)] [i (in-naturals)]) (flvector-set! right i (at row 0)))
    (unless (factor! factors n exchanges)
      (for ([i (in-range (* n n))]) (flvector-set! factors i +nan.0)))
    (store! 0))
  (define (step! k)
    (for ([row (in-vector b)] [columns (in-vector changing)] [i (in-naturals)])
      (put! right i (at row k))
      (for ([j (in-list columns)])
        (subtract-convolution! right i k (vector-ref A (+ (* i n) j)) (vector-ref x j))))
    (store! k))
  (lambda (k) (if (= k 0) (start!) (step! k))))

(define (subtract-convolution! right i k a x)
  (convolve k 1 k ([s a x]) (put! right i (fl- (at right i) s))))
