#lang racket/base
;; Random programs: straight lines of operations on what was computed before,
;; with sharing, conditions on values, and closures.

(require mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         "../random.rkt")

(provide random-program)

;; -> a function of a vector of scalars, and how long that is.  No operation has a
;; singularity, and values stay of moderate size.
(define (random-program #:length [steps 15] #:conditions? [conditions? #t])
  (define inputs (random-integer 1 5))
  (define program
    (for/list ([i (in-range steps)])
      (random-step (+ inputs i) conditions?)))
  (values
   (lambda (xs)
     (for/fold ([values (reverse (vector->list xs))] #:result (car values))
               ([step (in-list program)])
       (define known (list->vector values))
       (cons (step (lambda (i) (vector-ref known (- (vector-length known) i 1)))) values)))
   inputs))

;; A step sees the values before it by number, mostly recent ones.
(define (random-step known conditions?)
  (define (pick) (if (zero? (random 3)) (random known) (max 0 (- known 1 (random 3)))))
  (define i (pick))
  (define j (pick))
  (define k (pick))
  (define c (random-rational))
  (case (random (if conditions? 11 8))
    [(0) (lambda (x) (g:+ (x i) (x j)))]
    [(1) (lambda (x) (g:- (x i) (g:* c (x j))))]
    [(2) (lambda (x) (g:* (x i) (g:sin (x j))))]
    [(3) (lambda (x) (g:/ (x i) (g:+ 2 (g:square (x j)))))]
    [(4) (lambda (x) (g:cos (g:* c (x i))))]
    [(5) (lambda (x) (g:sqrt (g:+ 1 (g:square (x i)))))]
    [(6) (lambda (x) (g:exp (g:sin (x i))))]
    [(7) (lambda (x) (g:atan (x i) (g:+ 1 (g:square (x j)))))]
    [(8) (lambda (x) (if (g:< (x i) (x j)) (x k) (g:* c (x i))))]
    [(9) (lambda (x) (g:tanh (g:+ (x i) (x j) (x k))))]
    [(10) (lambda (x)
            (define (scaled y) (g:* (x i) y))
            (if (g:positive? (x j)) (g:sin (scaled (x k))) (scaled c)))]))
