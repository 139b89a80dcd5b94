#lang racket/base
;; The matrices of the benchmarks.

(require mechanics)

(provide symbolic-matrix tridiagonal-matrix sparse-matrix frequency-matrix
         flonum-matrix integer-matrix ones)

(define (symbol name . indices)
  (string->symbol (apply string-append name (map number->string indices))))

;; No two entries alike.
(define (symbolic-matrix n)
  (m:generate n n (lambda (i j) (symbol "a" i j))))

(define (tridiagonal-matrix n)
  (m:generate n n (lambda (i j)
                    (if (<= (abs (- i j)) 1) (symbol "a" i j) 0))))

;; Pairs of rows that need only pairs before them.
(define (sparse-matrix n)
  (m:generate n n (lambda (i j)
                    (cond [(= (quotient i 2) (quotient j 2)) (symbol "a" i j)]
                          [(and (> i j) (even? (+ i j))) (symbol "c" i j)]
                          [else 0]))))

;; K - w M for coupled oscillators of unlike masses.
(define (frequency-matrix n)
  (m:generate n n (lambda (i j)
                    (- (/ 1 (+ 1 (abs (- i j)))) (if (= i j) (* (+ i 1) 'w) 0)))))

(define (flonum-matrix n)
  (m:generate n n (lambda (i j) (+ (sin (* 1.0 (+ 1 i) (+ 2 (* j j)))) (if (= i j) 2.0 0.0)))))

;; Of numbers without a pattern.
(define (integer-matrix n)
  (m:generate n n (lambda (i j) (- (modulo (modulo (expt (+ 3 i (* 50 j)) 5) 1009) 19) 9))))

(define (ones n) (s:generate n 'up (lambda (i) 1)))
