#lang racket/base
;; Dense linear systems of flonums, for the inner loops of integration: one matrix
;; with many right-hand sides, or with one.
;;
;; Gaussian elimination with partial pivoting leaves A, row by row in an flvector, as
;; the product of a lower triangle with ones on the diagonal, below it, and an upper
;; one, both of them in A's place; `exchanges` remembers which row was taken as pivot.
;; That takes n³/3 multiplications, and each solution n².

(require racket/fixnum racket/flonum racket/unsafe/ops)

(provide factor! solve-factored! solve-dense!)

(define-syntax-rule (each (i from to) body ...)
  (let ([end to])
    (let loop ([i from])
      (when (unsafe-fx< i end)
        body ...
        (loop (unsafe-fx+ i 1))))))

(define-syntax-rule (with-entries (entry entry! m n) body ...)
  (let ()
    (define-syntax-rule (entry i j)
      (unsafe-flvector-ref m (unsafe-fx+ (unsafe-fx* i n) j)))
    (define-syntax-rule (entry! i j x)
      (unsafe-flvector-set! m (unsafe-fx+ (unsafe-fx* i n) j) x))
    body ...))

;; m : flvector of n² entries, which are changed; exchanges : fxvector of n entries
;; -> #f if m is singular, or a pivot is not a number
(define (factor! m n exchanges)
  (with-entries (entry entry! m n)
    (define (pivot-row k)
      (let loop ([i (unsafe-fx+ k 1)] [best k])
        (cond [(unsafe-fx= i n) best]
              [(unsafe-fl> (unsafe-flabs (entry i k)) (unsafe-flabs (entry best k)))
               (loop (unsafe-fx+ i 1) i)]
              [else (loop (unsafe-fx+ i 1) best)])))
    (define (exchange! i k)
      (each (j 0 n)
        (let ([x (entry i j)])
          (entry! i j (entry k j))
          (entry! k j x))))
    (define (clear-below! k)
      (define inverse (unsafe-fl/ 1.0 (entry k k)))
      (each (i (unsafe-fx+ k 1) n)
        (let ([factor (unsafe-fl* (entry i k) inverse)])
          (entry! i k factor)
          (unless (unsafe-fl= factor 0.0)
            (each (j (unsafe-fx+ k 1) n)
              (entry! i j (unsafe-fl- (entry i j) (unsafe-fl* factor (entry k j)))))))))
    (let loop ([k 0])
      (cond [(unsafe-fx= k n) #t]
            [else
             (define p (pivot-row k))
             (fxvector-set! exchanges k p)
             (unless (unsafe-fx= p k) (exchange! p k))
             (and (< 0.0 (unsafe-flabs (entry k k)) +inf.0)
                  (begin (clear-below! k)
                         (loop (unsafe-fx+ k 1))))]))))

;; b, the right-hand side, becomes the solution.
(define (solve-factored! m n exchanges b)
  (with-entries (entry entry! m n)
    (define-syntax-rule (term i j) (unsafe-fl* (entry i j) (unsafe-flvector-ref b j)))
    (each (k 0 n)
      (let* ([p (unsafe-fxvector-ref exchanges k)]
             [x (unsafe-flvector-ref b p)])
        (unsafe-flvector-set! b p (unsafe-flvector-ref b k))
        (unsafe-flvector-set! b k x)))
    (each (i 1 n)
      (let loop ([j 0] [sum (unsafe-flvector-ref b i)])
        (if (unsafe-fx= j i)
            (unsafe-flvector-set! b i sum)
            (loop (unsafe-fx+ j 1) (unsafe-fl- sum (term i j))))))
    (let up ([i (unsafe-fx- n 1)])
      (unless (unsafe-fx< i 0)
        (let loop ([j (unsafe-fx+ i 1)] [sum (unsafe-flvector-ref b i)])
          (if (unsafe-fx= j n)
              (unsafe-flvector-set! b i (unsafe-fl/ sum (entry i i)))
              (loop (unsafe-fx+ j 1) (unsafe-fl- sum (term i j)))))
        (up (unsafe-fx- i 1))))))

;; Both in one: b becomes the solution of m x = b, or nothing in it is a number.
(define (solve-dense! m n b)
  (define exchanges (make-fxvector n))
  (if (factor! m n exchanges)
      (solve-factored! m n exchanges b)
      (each (k 0 n) (unsafe-flvector-set! b k +nan.0))))
