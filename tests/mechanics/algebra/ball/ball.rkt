#lang racket/base
;; Balls hold the values of what is computed with them, and shrink with more bits.
;;
;; Arithmetic is judged by exact rationals, roots by their squares, functions by bigfloats of
;; many more digits: balls are made around rationals, so each holds the value at its middle, at
;; a random point within, and at its ends.

(require mechanics/algebra/ball/ball
         mechanics/algebra/ball/ball-elementary
         mechanics/algebra/ball/ball-functions
         "../../support/checks.rkt"
         "../../support/bigfloats.rkt" "../../support/random.rkt" "../../support/skip.rkt")

(define (unit b) (expt 2 (ball-scale b)))
(define (lower b) (* (ball-lower b) (unit b)))
(define (upper b) (* (ball-upper b) (unit b)))
(define (holds? b x) (<= (lower b) x (upper b)))

;; A ball around x, of relative radius 2^-n, and a rational in it.
(define (ball-about x n)
  (define scale (- (integer-length (numerator x)) (integer-length (denominator x)) 60))
  (define m (round (/ x (expt 2 scale))))
  (make-ball m (+ 1 (arithmetic-shift (abs m) (- n))) scale 64))

(define (point-in b) (+ (lower b) (* (/ (random 1001) 1000) (- (upper b) (lower b)))))

;; From 10^-12 to 10^3, of either sign.
(define (random-argument)
  (define x (* (random-rational) (expt 10 (random-integer -12 2))))
  (if (zero? (random 2)) x (random-rational)))

;; -> a ball, or what is raised instead
(define (attempt f . arguments) (with-handlers ([symbol? values]) (apply f arguments)))

(define precisions '(30 56 160 320))

(test-case "sums, products and quotients hold those of the points in the balls"
  (with-seeds 5
    (for* ([p (in-list precisions)] [_ (in-range 40)])
      (define a (ball-about (random-argument) (random-integer 8 80)))
      (define b (ball-about (random-argument) (random-integer 8 80)))
      (define x (point-in a))
      (define y (point-in b))
      (define n (random-choice -3 -2 -1 1 2 5 12))
      (check-true (holds? (ball+ a b p) (+ x y)))
      (check-true (holds? (ball- a b p) (- x y)))
      (check-true (holds? (ball* a b p) (* x y)))
      (check-true (holds? (ball/ a b p) (/ x y)))
      (check-true (holds? (ball-abs a) (abs x)))
      (check-true (holds? (ball-integer-power a n p) (expt x n)))
      (define root (ball-sqrt (ball-abs a) p))
      (check-true (<= (expt (lower root) 2) (abs x) (expt (upper root) 2))))))

(test-case "sums of numbers of very different sizes hold them"
  (for* ([x (in-list (list 1 -3/7 (expt 10 80)))] [y (in-list (list (expt 7 -200) (expt 3 -900)))])
    (define sum (ball+ (exact->ball x 60) (exact->ball y 60) 60))
    (check-true (holds? sum (+ x y)))))

(test-case "balls of few units, and those around 0, hold the values at their ends"
  (define halved (ball/ (ball 5 5 0) (exact->ball 1/2 60) 60))
  (check-true (and (holds? halved 0) (holds? halved 20)))
  (define root (ball-sqrt (ball 4 1 0) 60))
  (check-true (and (<= (expt (lower root) 2) 3) (>= (expt (upper root) 2) 5)))
  (define size (ball-abs (ball 1 3 0)))
  (check-true (and (holds? size 0) (holds? size 4))))

(test-case "a sum of exact numbers is known to nearly all bits"
  (for ([p (in-list precisions)] [x (list 1 (expt 2 -40) (expt 2 200))])
    (define sum (ball+ (exact->ball x p) (exact->ball 1/3 p) p))
    (check-true (< (- (upper sum) (lower sum)) (* (expt 2 (- 8 p)) (+ x 1))))))

;; ---------------------------------------------------------------------------
;; Functions

;; name of the bigfloat function, ours, domain of an argument
(struct function (name ball domain))

(define (anything x) x)
(define (unit-interval x) (/ x (+ 1 (abs x))))

(define functions
  (list (function 'bfexp ball-exp anything) (function 'bflog ball-log abs)
        (function 'bfsin ball-sin anything) (function 'bfcos ball-cos anything)
        (function 'bftan ball-tan anything) (function 'bfasin ball-asin unit-interval)
        (function 'bfacos ball-acos unit-interval) (function 'bfatan ball-atan anything)
        (function 'bfsinh ball-sinh anything) (function 'bfcosh ball-cosh anything)
        (function 'bftanh ball-tanh anything) (function 'bfasinh ball-asinh anything)
        (function 'bfacosh ball-acosh (lambda (x) (+ 1 (abs x))))
        (function 'bfatanh ball-atanh unit-interval) (function 'bferf ball-erf anything)
        (function 'bfsqrt ball-sqrt abs)))

;; The value of the function at rational arguments, far more precisely than any ball here.
(define (true-value name . xs)
  (define (big-rational x) ((big 'bf/) ((big 'bf) (numerator x)) ((big 'bf) (denominator x))))
  (parameterize ([(big 'bf-precision) 700])
    ((big 'bigfloat->rational) (apply (big name) (map big-rational xs)))))

;; From arctangents, for bigfloats have no angle of a point.
(define (true-angle y x)
  (define half (true-value 'bfatan (/ y x)))
  (define pi (* 4 (true-value 'bfatan 1)))
  (cond [(> x 0) half] [(> y 0) (+ half pi)] [else (- half pi)]))

(define (check-enclosed f x n p)
  (define b (ball-about x n))
  (define value (attempt (function-ball f) b p))
  (when (ball? value)
    (for ([y (in-list (list x (point-in b) (lower b) (upper b)))])
      (check-true (holds? value (true-value (function-name f) y))
                  (format "~a at ~a, ~a bits" (function-name f) y p))))
  (ball? value))

(skip-unless bigfloats? no-bigfloats
  (test-case "functions hold their values at the points in the balls"
    (for ([f (in-list functions)])
      (with-seed 7
        (define found
          (for*/sum ([p (in-list precisions)] [_ (in-range 12)])
            (define x ((function-domain f) (random-argument)))
            (if (check-enclosed f x (random-integer 10 60) p) 1 0)))
        (check-true (> found 40) (format "~a" (function-name f))))))

  (test-case "sharp arguments have values that are known to nearly all bits"
    (for ([f (in-list functions)])
      (with-seed 8
        (for* ([p (in-list '(80 160 320))] [_ (in-range 6)])
          (define x ((function-domain f) (/ (random-integer 1 4000) 256)))
          (define true (true-value (function-name f) x))
          (define value ((function-ball f) (exact->ball x (+ p 20)) p))
          (check-true (holds? value true) (format "~a at ~a" (function-name f) x))
          (check-true (< (- (upper value) (lower value)) (* (expt 2 (- 24 p)) (+ 1 (abs true))))
                      (format "~a at ~a, ~a bits" (function-name f) x p))))))

  (test-case "small angles are known to nearly all bits, too"
    (for* ([p (in-list precisions)] [k (list 10 20 30 (* 3 p))] [y (in-list '(1 -3))])
      (define small (/ y (expt 2 k)))
      (define value (ball-angle (exact->ball small p) (exact->ball 1 p) p))
      (check-true (holds? value (true-angle small 1)))
      (check-true (< (- (upper value) (lower value)) (* (expt 2 (- 8 p)) (abs small))))))

  (test-case "an angle is known to as many bits as are asked for"
    (define value (ball-angle (exact->ball 1 600) (exact->ball 2 600) 600))
    (check-true (holds? value (true-angle 1 2)))
    (check-true (< (- (upper value) (lower value)) (expt 2 -590))))

  (test-case "logarithms near 1 are known to nearly all bits, too"
    (for* ([p (in-list precisions)] [k (in-list '(10 20 30))] [side (in-list '(1 -1))])
      (define x (+ 1 (/ side (expt 2 k))))
      (define value (ball-log (exact->ball x (+ p 40)) p))
      (check-true (holds? value (true-value 'bflog x)))
      (check-true (< (- (upper value) (lower value)) (expt 2 (- 8 p k))))))

  (test-case "functions that are as small as a small argument, too"
    (for* ([p (in-list precisions)] [k (in-list '(10 20 30))]
           [name (in-list '(bfsin bftan bfasin bfatan bfsinh bftanh bfasinh bfatanh))])
      (define f (findf (lambda (f) (eq? (function-name f) name)) functions))
      (define x (/ 3 (expt 2 k)))
      (define value ((function-ball f) (exact->ball x (+ p 8)) p))
      (check-true (holds? value (true-value name x)) (format "~a" name))
      (check-true (< (- (upper value) (lower value)) (* (expt 2 (- 8 p)) x))
                  (format "~a, ~a bits" name p))))

  (test-case "the angle of a point holds that of the points around it"
    (with-seed 9
      (for* ([p (in-list precisions)] [_ (in-range 20)])
        (define y (ball-about (random-argument) (random-integer 10 60)))
        (define x (ball-about (random-argument) (random-integer 10 60)))
        (define angle (attempt ball-angle y x p))
        (when (ball? angle)
          (check-true (holds? angle (true-angle (point-in y) (point-in x))))))))

  (test-case "powers hold those of the points in the balls"
    (with-seed 10
      (for* ([p (in-list precisions)] [_ (in-range 20)])
        (define x (ball-about (abs (random-argument)) (random-integer 10 60)))
        (define y (ball-about (random-rational) (random-integer 10 60)))
        (check-true (holds? (ball-power x y p) (true-value 'bfexpt (point-in x) (point-in y))))))))

;; ---------------------------------------------------------------------------
;; Edges

(test-case "outside of the domain there is no value, at its edge none is known"
  (define (at f x) (attempt f (exact->ball x 60) 60))
  (define (near f x) (attempt f (ball-about x 40) 60))
  (for ([f+x (in-list (list (cons ball-sqrt -1) (cons ball-log -2) (cons ball-asin 2)
                            (cons ball-acos -2) (cons ball-acosh 1/2) (cons ball-acosh -3)
                            (cons ball-atanh 2) (cons ball-atanh -2) (cons ball-log 0)
                            (cons ball-atanh 1) (cons ball-atanh -1)))])
    (check-eq? (at (car f+x) (cdr f+x)) no-value (format "~a" f+x)))
  (for ([f+x (in-list (list (cons ball-asin 1) (cons ball-acos -1) (cons ball-acosh 1)
                            (cons ball-atanh 1)))])
    (check-eq? (near (car f+x) (cdr f+x)) unknown (format "~a" f+x)))
  (define zero (ball 0 1 -50))
  (for ([f (in-list (list ball-sqrt ball-log))]) (check-eq? (attempt f zero 60) unknown))
  (check-eq? (attempt ball/ (exact->ball 1 60) zero 60) unknown)
  (check-eq? (attempt ball/ (exact->ball 1 60) (ball -1 1 -50) 60) unknown)
  (check-eq? (attempt ball/ (exact->ball 1 60) (exact->ball 0 60) 60) no-value)
  (check-eq? (attempt ball-angle zero (exact->ball -1 60) 60) unknown)
  (check-eq? (attempt ball-angle zero zero 60) unknown)
  (check-pred ball? (attempt ball-angle zero (exact->ball 1 60) 60))
  (check-pred ball? (attempt ball-angle (exact->ball 1 60) zero 60)))

(test-case "what is known to within more than 1 has no sine, what is enormous no exponential"
  (for* ([f (in-list (list ball-sin ball-cos ball-exp))] [b (list (ball 0 3 0) (ball 0 1 3))])
    (check-eq? (attempt f b 60) unknown))
  (check-eq? (attempt ball-exp (exact->ball (expt 10 9) 60) 60) unknown)
  (check-eq? (attempt ball-sin (exact->ball (expt 2 5000) 60) 60) unknown)
  (check-eq? (attempt ball-integer-power (exact->ball 3 60) (expt 10 18) 60) unknown))

(test-case "a flonum is uncertain in its last places"
  (for ([x (in-list '(0.1 -3.7e200 1e-300 5e-324 0.0 1.0))])
    (define b (flonum->ball x 80))
    (define exact (inexact->exact x))
    (check-true (holds? b exact))
    (check-true (holds? b (* exact (+ 1 (expt 2 -49)))))
    (check-false (and (not (zero? x)) (holds? b (* exact (+ 1 (expt 2 -44))))))))
