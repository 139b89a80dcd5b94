#lang racket/base
;; Functions through data: what they reproduce, how fast they converge, what they refuse.

(require mechanics
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define (evenly a b n) (for/list ([k (in-range (+ n 1))]) (+ a (* k (/ (- b a) n)))))

;; The greatest distance of f and g at many places from a to b.
(define (distance f g a b)
  (for/fold ([d 0]) ([x (in-list (evenly a b 997))]) (max d (abs (- (f x) (g x))))))

;; How many times smaller an error is when the distance of points is halved, as a power of 2.
(define (order make f a b n)
  (define (error-with n) (let ([xs (evenly a b n)]) (distance (make xs) f a b)))
  (/ (log (/ (error-with n) (error-with (* 2 n)))) (log 2.0)))

(define places '(0 1/3 1 3/2 9/4 3 19/5 4))
(define xs '(0 1 3/2 3 4))
(define (cubic x) (+ 2 (* -3 x) (* 1/2 x x) (* 5 (expt x 3))))

;; ---------------------------------------------------------------------------

(test-case "all go through the data, exactly if they are exact"
  (define ys '(2 -1 0 7/2 1))
  (for ([f (list (cubic-spline xs ys)
                 (cubic-spline xs ys #:ends 'natural)
                 (cubic-spline xs ys #:ends '(1 -2))
                 (Hermite-spline xs ys '(0 1 2 3 4))
                 (monotone-spline xs ys)
                 (linear-interpolation xs ys)
                 (barycentric-interpolation-function ys xs)
                 (Lagrange-interpolation-function ys xs)
                 (Hermite-interpolation-function ys '(0 1 2 3 4) xs))])
    (check-equal? (map f xs) ys (format "~a" f))
    (check-true (flonum? (f 0.7)))))

(test-case "cubics come out exactly, with their derivatives"
  (define ys (map cubic xs))
  (define slopes (map (D cubic) xs))
  (for ([f (list (cubic-spline xs ys)
                 (cubic-spline xs ys #:ends (list (car slopes) ((D cubic) 4)))
                 (Hermite-spline xs ys slopes)
                 (barycentric-interpolation-function ys xs)
                 (Hermite-interpolation-function ys slopes xs))])
    (for ([x (in-list places)])
      (check-equal? (f x) (cubic x))
      (check-equal? ((D f) x) ((D cubic) x))
      (check-equal? (((expt D 2) f) x) (((expt D 2) cubic) x)))))

(test-case "two points make a line, three a parabola"
  (check-equal? ((cubic-spline '(0 2) '(1 5)) 1) 3)
  (check-equal? ((cubic-spline '(0 1 3) '(0 1 9)) 2) 4)
  (check-equal? ((cubic-spline '(0 2) '(1 5) #:ends 'natural) 1/2) 2)
  (check-equal? ((monotone-spline '(0 2) '(1 5)) 1) 3))

(test-case "the ends of a spline are as asked for, and its second derivative has no jumps"
  (define ys '(2 -1 0 7/2 1))
  (define natural (cubic-spline xs ys #:ends 'natural))
  (define second (expt D 2))
  (check-equal? (map (second natural) '(0 4)) '(0 0))
  (define clamped (cubic-spline xs ys #:ends '(7 -2)))
  (check-equal? (map (D clamped) '(0 4)) '(7 -2))
  (define periodic (cubic-spline xs '(2 -1 0 7/2 2) #:ends 'periodic))
  (check-equal? ((D periodic) 0) ((D periodic) 4))
  (check-equal? ((second periodic) 0) ((second periodic) 4))
  (define h 1/1000000)
  (for* ([f (list natural clamped periodic (cubic-spline xs ys))] [x '(1 3/2 3)])
    (check-true (< (abs (- ((second f) (- x h)) ((second f) x))) 1/1000))))

(test-case "orders of convergence"
  (define (f x) (sin (* 2 x)))
  (define (values-at xs) (map (lambda (x) (f (exact->inexact x))) xs))
  (define (spline ends) (lambda (xs) (cubic-spline xs (values-at xs) #:ends ends)))
  (define-syntax-rule (check-order low make high a b n)
    (check-true (< low (order make f a b n) high) (format "~a" (order make f a b n))))
  (check-order 3.8 (spline 'not-a-knot) 4.6 0.0 3.0 40)
  (check-order 3.8 (spline (list 2.0 (* 2 (cos 6.0)))) 4.2 0.0 3.0 40)
  (check-order 3.8 (spline 'periodic) 4.2 0.0 :pi 40)
  (check-order 1.8 (spline 'natural) 2.2 0.0 2.0 40)  ; f'' is not 0 at the end
  (check-order 3.8 (lambda (xs) (Hermite-spline xs (values-at xs) (map (D f) xs))) 4.2 0.0 3.0 40)
  (check-order 1.9 (lambda (xs) (linear-interpolation xs (values-at xs))) 2.1 0.0 3.0 40))

(test-case "polynomials through Chebyshev's points converge geometrically"
  (define (runge x) (/ 1 (+ 1 (* 25 x x))))
  (define (error-with n)
    (define xs (for/list ([k (in-range (+ n 1))]) (cos (/ (* :pi k) n))))
    (distance (barycentric-interpolation-function (map runge xs) xs) runge -0.999 0.999))
  ;; 1/ρⁿ, where the pole i/5 gives ρ = 1/5 + √26/5
  (define rate (expt (/ (error-with 100) (error-with 60)) 1/40))
  (check-= rate (/ 5 (+ 1 (sqrt 26.0))) 0.02)
  (check-true (< (error-with 300) 1e-13)))

(test-case "monotone data stay monotone, and peaks are not exceeded"
  (define ys '(0 0 1/10 9 9 9 2))
  (define f (monotone-spline '(0 1 2 3 4 5 6) ys))
  (define samples (map f (evenly 0 6 600)))
  (check-true (for/and ([y samples]) (<= 0 y 9)))
  (check-true (for/and ([a (evenly 0 49/10 490)]) (<= (f a) (f (+ a 1/100)))))
  (check-true (> (apply max (map (cubic-spline '(0 1 2 3 4 5 6) ys) (evenly 0 6 600))) 9.5)))

(test-case "values may be tuples or symbols, points numbers of any sort"
  (define f (cubic-spline '(0 1 2 3) (list (up 0 1) (up 1 3) (up 8 5) (up 27 7))))
  (check-equal? (f 3/2) (up 27/8 4))
  (check-equal? ((D f) 2) (up 12 2))
  (check-equal? (simplify ((linear-interpolation '(0 2) '(a b)) 1)) (simplify (/ (+ 'a 'b) 2)))
  (check-equal? (simplify ((cubic-spline #(0 1) (up 'a 'b)) 1)) 'b)
  (check-= ((cubic-spline '(0.0 1.0 2.0 3.0) '(0 1 8 27)) 1.5) 3.375 1e-14))

(test-case "they are functions of the arithmetic"
  (define f (cubic-spline '(0 1 2 3) '(0 1 4 9)))
  (check-equal? ((+ f 1) 2) 5)
  (check-equal? (expression f) '(cubic-spline from 0 to 3))
  (check-= (definite-integral f 0 3) 9 1e-10)
  (define ((driven force) (up t x v)) (up 1 v (force t)))
  (define end ((state-advancer driven f) (up 0 0 0) 3 1e-12))
  (check-= (ref end 2) 9 1e-10))

(skip-unless bigfloats? no-bigfloats
  (test-case "in higher precision"
    (define f (cubic-spline '(0 1 2 3) '(0 1 8 27)))
    (define x (bigfloat "1.1" 200))
    (check-true (< (abs (- (f x) (expt x 3))) 1e-58))))

(test-case "outside of the data there is nothing, unless asked for"
  (define f (cubic-spline '(0 1 2 3) '(0 1 8 27)))
  (check-exn
   (regexp (string-append "^cubic-spline: there are no data for the argument\n  argument: 7/2\n"
                          "  from: 0\n  to: 3\n  with #:extrapolate\\? #t"))
   (lambda () (f 7/2)))
  (check-exn #rx"argument: -0.1" (lambda () (f -0.1)))
  (check-equal? ((cubic-spline '(0 1 2 3) '(0 1 8 27) #:extrapolate? #t) 4) 64)
  (check-equal? ((linear-interpolation '(0 1) '(0 1) #:extrapolate? #t) -2) -2)
  (check-equal? ((barycentric-interpolation-function '(0 1 8 27) '(0 1 2 3)) 5) 125))

(test-case "mistakes"
  (check-exn #rx"cubic-spline: expected as many values as points.*values: 2.*points: 3"
             (lambda () (cubic-spline '(0 1 2) '(0 1))))
  (check-exn #rx"expected points in increasing order\n  point 1: 2\n  point 2: 1"
             (lambda () (cubic-spline '(0 2 1) '(0 1 2))))
  (check-exn #rx"linear-interpolation: two points are the same\n  point: 1"
             (lambda () (linear-interpolation '(0 1 1.0) '(0 1 2))))
  (check-exn #rx"barycentric-interpolation-function: two points are the same\n  point: 0"
             (lambda () (barycentric-interpolation-function '(0 1 2) '(0 1 0))))
  (check-exn #rx"Lagrange-interpolation-function: two points are the same\n  point: 0"
             (lambda () (Lagrange-interpolation-function '(0 1 2) '(0 1 0))))
  (check-exn #rx"Hermite-spline: expected as many slopes as points"
             (lambda () (Hermite-spline '(0 1) '(0 1) '(0))))
  (check-exn #rx"expected points that are real numbers\n  given: the symbol a"
             (lambda () (cubic-spline '(0 a) '(0 1))))
  (check-exn #rx"expected two points or more\n  given: 1" (lambda () (cubic-spline '(0) '(1))))
  (check-exn #rx"expected points in a list, a vector or a tuple\n  given: the number 3"
             (lambda () (cubic-spline 3 '(1))))
  (check-exn #rx"expected 'not-a-knot, 'natural, 'periodic or a list of the slopes"
             (lambda () (cubic-spline '(0 1) '(1 2) #:ends 'free)))
  (check-exn #rx"a periodic function has the same value at both ends\n  first: 1\n  last: 2"
             (lambda () (cubic-spline '(0 1) '(1 2) #:ends 'periodic)))
  (check-exn #rx"monotone-spline: expected values that are real numbers\n  given: the symbol a"
             (lambda () (monotone-spline '(0 1) '(1 a))))
  (check-exn
   #rx"cubic-spline: the function of these data takes a real number\n  given: the symbol x"
   (lambda () ((cubic-spline '(0 1) '(1 2)) 'x))))
