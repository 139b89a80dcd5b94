#lang racket/base
;; Compiled gradients: those of D, and of differences, for a few times the operations.

(require racket/flonum
         mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (random-point n) (for/flvector #:length n ([_ (in-range n)]) (+ 0.2 (* 0.6 (random)))))

(define (near? x y tolerance) (<= (abs (- x y)) (* tolerance (+ 1 (abs x) (abs y)))))

;; Against D and against central differences, at points in (0.2, 0.8)
(define (check-gradient f n)
  (define example (vector->up (make-vector n 0.5)))
  (define c (compile-function f example #:gradient? #t))
  (define (at v) (f (vector->up (for/vector ([x (in-flvector v)]) x))))
  (for ([_ (in-range 3)])
    (define v (random-point n))
    (define out (c v))
    (define slopes ((D f) (vector->up (for/vector ([x (in-flvector v)]) x))))
    (check-equal? (flvector-length out) (+ n 1))
    (check-true (near? (flvector-ref out 0) (at v) 1e-14))
    (for ([k (in-range n)])
      (define (moved h)
        (define w (flvector-copy v))
        (flvector-set! w k (+ h (flvector-ref v k)))
        (at w))
      (define d (flvector-ref out (+ k 1)))
      (unless (and (near? d (ref slopes k) 1e-12)
                   (near? d (/ (- (moved 1e-5) (moved -1e-5)) 2e-5) 1e-6))
        (check-equal? (list k d) (list k (ref slopes k))))))
  c)

(random-seed 17)

(test-case "every operation"
  (define (one f) (check-gradient (lambda (s) (* (ref s 1) (f (ref s 0)))) 2))
  (for ([f (list sin cos tan asin acos atan sinh cosh tanh asinh atanh exp log sqrt abs
                 (lambda (x) (acosh (+ 2 x))) (lambda (x) (expt x 3.7)) (lambda (x) (expt x -2))
                 (lambda (x) (expt 3 x)) (lambda (x) (expt x x)) (lambda (x) (/ 1 x))
                 (lambda (x) (/ x (+ 1 x))) (lambda (x) (- 2 x)) (lambda (x) 7) -)])
    (one f))
  (check-gradient (lambda (s) (+ (atan (ref s 0) (ref s 1)) (expt (ref s 0) (ref s 1)))) 2)
  (void (check-gradient (lambda (s) ((principal-value :pi) (* 3 (ref s 0) (ref s 1)))) 2)))

(test-case "a linear system inside"
  (define (f s)
    (define m (matrix-by-rows (list (+ 3 (ref s 0)) (ref s 1))
                              (list (sin (ref s 2)) (+ 2 (ref s 1)))))
    (define x (* (/ 1 m) (up (ref s 2) (square (ref s 0)))))
    (dot-product x (up 1 (ref s 1))))
  (void (check-gradient f 3)))

(test-case "a long sum costs a few times itself, however many variables"
  (define n 60)
  (define (chain s)
    (for/fold ([sum 0]) ([k (in-range (- n 1))])
      (+ sum (* (sin (ref s k)) (square (- (ref s (+ k 1)) (ref s k)))))))
  (define c (check-gradient chain n))
  (define plain (compile-function chain (vector->up (make-vector n 0.5))))
  (check-true (<= (compiled-function-operations c) (* 4 (compiled-function-operations plain)))))

(test-case "of tuples in tuples, in the order of their scalars; of one number"
  (define c (compile-function (lambda (s) (* (ref s 0) (ref s 1 0) (square (ref s 1 1))))
                              (up 1 (down 2 3)) #:gradient? #t))
  (check-equal? (c (flvector 2.0 3.0 5.0)) (flvector 150.0 75.0 50.0 60.0))
  (check-equal? ((compile-function cube 1 #:gradient? #t) (flvector 2.0)) (flvector 8.0 12.0)))

(test-case "a function that decides is evaluated as it is"
  (define c (compile-function (lambda (x) (if (< x 0) (square x) (* 3 x))) 1.0 #:gradient? #t))
  (check-equal? (c (flvector -2.0)) (flvector 4.0 -4.0))
  (check-equal? (c (flvector 2.0)) (flvector 6.0 3.0))
  (check-pred string? (compiled-function-reason c)))

(test-case "where there is no value, or no derivative, there is no number"
  (define c (compile-function (lambda (s) (* (ref s 1) (sqrt (ref s 0)))) (up 1 2) #:gradient? #t))
  (define out (c (flvector -1.0 1.0)))
  (check-false (ormap rational? (list (flvector-ref out 0) (flvector-ref out 1))))
  (check-false (rational? (flvector-ref ((compile-function abs 1 #:gradient? #t) (flvector 0.0))
                                        1))))

(test-case "a value that is not one number"
  (check-message (string-append
                  "compile-function: a gradient is that of a function whose value is one number\n"
                  "  value: (up 2.0 2.0), an up tuple of 2")
                 (compile-function (lambda (q) (* 2 q)) (up 1 1) #:gradient? #t)))
