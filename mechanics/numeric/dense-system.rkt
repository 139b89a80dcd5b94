#lang racket/base
;; One dense linear system of flonums, solved where it stands.
;;
;; For the inner loops of integration: the n × (n + 1) matrix [A b] lies row by
;; row in an flvector.  Gaussian elimination with partial pivoting, n³/3
;; multiplications, leaves the solution in the last column; if A is singular,
;; nothing there is a number.

(require racket/flonum racket/unsafe/ops)

(provide solve-dense!)

(define-syntax-rule (each (i from to) body ...)
  (let ([end to])
    (let loop ([i from])
      (when (unsafe-fx< i end)
        body ...
        (loop (unsafe-fx+ i 1))))))

;; m : flvector of n (n + 1) entries, which are changed
(define (solve-dense! m n)
  (define width (unsafe-fx+ n 1))
  (define-syntax-rule (at i j) (unsafe-fx+ (unsafe-fx* i width) j))
  (define-syntax-rule (entry i j) (unsafe-flvector-ref m (at i j)))
  (define-syntax-rule (entry! i j x) (unsafe-flvector-set! m (at i j) x))

  (define (pivot-row k)
    (let loop ([i (unsafe-fx+ k 1)] [best k])
      (cond [(unsafe-fx= i n) best]
            [(unsafe-fl> (unsafe-flabs (entry i k)) (unsafe-flabs (entry best k)))
             (loop (unsafe-fx+ i 1) i)]
            [else (loop (unsafe-fx+ i 1) best)])))

  (define (exchange! i k)
    (unless (unsafe-fx= i k)
      (each (j k width)
        (let ([x (entry i j)])
          (entry! i j (entry k j))
          (entry! k j x)))))

  (define (clear-below! k)
    (define inverse (unsafe-fl/ 1.0 (entry k k)))
    (each (i (unsafe-fx+ k 1) n)
      (let ([factor (unsafe-fl* (entry i k) inverse)])
        (unless (unsafe-fl= factor 0.0)
          (each (j (unsafe-fx+ k 1) width)
            (entry! i j (unsafe-fl- (entry i j) (unsafe-fl* factor (entry k j)))))))))

  (define (substitute-back! k)
    (define sum
      (let loop ([j (unsafe-fx+ k 1)] [sum (entry k n)])
        (if (unsafe-fx= j n)
            sum
            (loop (unsafe-fx+ j 1) (unsafe-fl- sum (unsafe-fl* (entry k j) (entry j n)))))))
    (entry! k n (unsafe-fl/ sum (entry k k))))

  (each (k 0 n)
    (exchange! (pivot-row k) k)
    (clear-below! k))
  (if (for/and ([k (in-range n)]) (< 0.0 (abs (entry k k)) +inf.0))
      (for ([k (in-range (- n 1) -1 -1)]) (substitute-back! k))
      (for ([k (in-range n)]) (entry! k n +nan.0))))
