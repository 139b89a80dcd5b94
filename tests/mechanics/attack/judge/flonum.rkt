#lang racket/base
;; Intervals between flonums, rounded outwards by more than the functions of the C
;; library err: 2 units in the last place for arithmetic, 16 for functions.

(require racket/flonum
         "interval.rkt")

(provide flonum-intervals)

(define ulp 2.220446049250313e-16)
(define least 1e-300)

(define (outwards low high slack)
  (define a (fl- low (fl+ (fl* slack (flabs low)) least)))
  (define b (fl+ high (fl+ (fl* slack (flabs high)) least)))
  (unless (and (fl< -1e280 a) (fl< b 1e280)) (fail-unknown))
  (interval a b))

(define (rounded low high) (outwards low high ulp))
(define (computed low high) (outwards low high (fl* 16.0 ulp)))

(define (from q)
  (define x (real->double-flonum q))
  (if (and (fl< (flabs x) 1e280) (= x q)) (interval x x) (rounded x x)))

(define (add i j)
  (rounded (fl+ (interval-low i) (interval-low j)) (fl+ (interval-high i) (interval-high j))))
(define (subtract i j)
  (rounded (fl- (interval-low i) (interval-high j)) (fl- (interval-high i) (interval-low j))))

(define (corners f i j)
  (define-values (a b c d)
    (values (interval-low i) (interval-high i) (interval-low j) (interval-high j)))
  (define-values (p q r s) (values (f a c) (f a d) (f b c) (f b d)))
  (rounded (flmin (flmin p q) (flmin r s)) (flmax (flmax p q) (flmax r s))))

(define (multiply i j) (corners fl* i j))
(define (divide i j) (corners fl/ i j))         ; j does not hold 0

(define (square i)
  (define-values (a b) (values (interval-low i) (interval-high i)))
  (define-values (p q) (values (fl* a a) (fl* b b)))
  (rounded (if (and (fl<= a 0.0) (fl<= 0.0 b)) 0.0 (flmin p q)) (flmax p q)))

(define (integer-power i n)
  (cond [(eqv? n 1) i]
        [(even? n) (square (integer-power i (quotient n 2)))]
        [else (multiply i (integer-power i (- n 1)))]))

(define ((increasing f) i) (computed (f (interval-low i)) (f (interval-high i))))

;; f has values in [-1, 1] and changes no faster than its argument.
(define ((wave f) i)
  (define-values (a b) (values (interval-low i) (interval-high i)))
  (define radius (fl+ (fl* 0.5001 (fl- b a)) (fl* ulp (fl+ (flabs a) (flabs b)))))
  (define y (f (fl* 0.5 (fl+ a b))))
  (define slack (fl+ radius (fl* 16.0 ulp)))
  (interval (flmax -1.0 (fl- y slack)) (flmin 1.0 (fl+ y slack))))

(define (join i j)
  (interval (flmin (interval-low i) (interval-low j)) (flmax (interval-high i) (interval-high j))))

(define flonum-intervals
  (arithmetic from inexact->exact add subtract multiply divide integer-power
              (increasing (lambda (x) (flsqrt (flmax 0.0 x))))
              (increasing flexp) (increasing fllog) (wave flsin) (wave flcos)
              (increasing flatan)
              (lambda () (computed 3.141592653589793 3.141592653589793))
              join))
