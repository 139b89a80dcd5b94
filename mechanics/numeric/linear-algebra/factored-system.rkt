#lang racket/base
;; Dense linear systems of flonums, for the inner loops of integration: one matrix
;; with many right-hand sides, or with one.
;;
;; Gaussian elimination with partial pivoting leaves A, row by row in an flvector, as
;; the product of a lower triangle with ones on the diagonal, below it, and an upper
;; one, both of them in A's place; `exchanges` remembers which row was taken as pivot.
;; That takes n³/3 multiplications, and each solution n².

(require racket/fixnum
         racket/unsafe/ops
         "../unboxed-loop.rkt")

(provide factor! solve-factored! solve-dense!)

;; Rows are walked by the place in m where they begin: row i begins at i n.

;; m : flvector of n² entries, which are changed; exchanges : fxvector of n entries
;; -> #f if m is singular, or a pivot is not a number
(define (factor! m n exchanges)
  (let loop ([k 0] [row 0])
    (cond [(unsafe-fx= k n) #t]
          [else
           (define p (pivot-row m n k row))
           (fxvector-set! exchanges k p)
           (unless (unsafe-fx= p k) (exchange-rows! m n (unsafe-fx* p n) row))
           (and (< 0.0 (unsafe-flabs (at m (unsafe-fx+ row k))) +inf.0)
                (begin (clear-below! m n k row)
                       (loop (unsafe-fx+ k 1) (unsafe-fx+ row n))))])))

;; The row, from the k-th on, which begins at `row`, with the greatest entry in column k.
(define (pivot-row m n k row)
  (let loop ([i (unsafe-fx+ k 1)] [place (unsafe-fx+ row (unsafe-fx+ k n))]
             [best k] [greatest (unsafe-flabs (at m (unsafe-fx+ row k)))])
    (cond [(unsafe-fx= i n) best]
          [else
           (define x (unsafe-flabs (at m place)))
           (define next (unsafe-fx+ place n))
           (if (unsafe-fl> x greatest)
               (loop (unsafe-fx+ i 1) next i x)
               (loop (unsafe-fx+ i 1) next best greatest))])))

(define (exchange-rows! m n row other)
  (each (j 0 n)
    (let ([x (at m (unsafe-fx+ row j))])
      (put! m (unsafe-fx+ row j) (at m (unsafe-fx+ other j)))
      (put! m (unsafe-fx+ other j) x))))

;; Clears column k below row k by multiples of this row, and keeps their factors in its place.
(define (clear-below! m n k row)
  (define inverse (unsafe-fl/ 1.0 (at m (unsafe-fx+ row k))))
  (define end (unsafe-fx* n n))
  (let loop ([below (unsafe-fx+ row n)])
    (when (unsafe-fx< below end)
      (let ([factor (unsafe-fl* (at m (unsafe-fx+ below k)) inverse)])
        (put! m (unsafe-fx+ below k) factor)
        (unless (unsafe-fl= factor 0.0)
          (subtract-row! m below row (unsafe-fx+ k 1) n factor)))
      (loop (unsafe-fx+ below n)))))

;; Subtracts from a row `factor` times another, in the columns given.
(define-syntax-rule (subtract-row! m row other from n factor)
  (let ([difference (unsafe-fx- other row)])
    (each (p (unsafe-fx+ row from) (unsafe-fx+ row n))
      (put! m p (unsafe-fl- (at m p) (unsafe-fl* factor (at m (unsafe-fx+ p difference))))))))

;; b, the right-hand side, becomes the solution.
(define (solve-factored! m n exchanges b)
  (each (k 0 n)
    (let* ([p (unsafe-fxvector-ref exchanges k)]
           [x (at b p)])
      (put! b p (at b k))
      (put! b k x)))
  (let down ([i 1] [row n])
    (when (unsafe-fx< i n)
      (put! b i (less-products m row b 0 i (at b i)))
      (down (unsafe-fx+ i 1) (unsafe-fx+ row n))))
  (let up ([i (unsafe-fx- n 1)] [row (unsafe-fx* n (unsafe-fx- n 1))])
    (unless (unsafe-fx< i 0)
      (put! b i (unsafe-fl/ (less-products m row b (unsafe-fx+ i 1) n (at b i))
                            (at m (unsafe-fx+ row i))))
      (up (unsafe-fx- i 1) (unsafe-fx- row n)))))

;; x less the products of a row and b in the columns given
(define-syntax-rule (less-products m row b from to x)
  (let ([end to])
    (let loop ([j from] [rest x])
      (if (unsafe-fx= j end)
          rest
          (loop (unsafe-fx+ j 1)
                (unsafe-fl- rest (unsafe-fl* (at m (unsafe-fx+ row j)) (at b j))))))))

;; Factors and solves: b becomes the solution of m x = b; of a singular m, all not-a-number.
(define (solve-dense! m n exchanges b)
  (if (factor! m n exchanges)
      (solve-factored! m n exchanges b)
      (each (k 0 n) (put! b k +nan.0))))
