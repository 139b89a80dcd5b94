#lang racket/base
;; Is a path S-expression in t a motion?  By differences of many digits: nothing is
;; differentiated.

(require "evaluate.rkt" "fixed.rkt" "point.rkt")

(provide kink-near residual-size)

(define A (fixed-intervals 320))

(define (path-value path t)
  (define v (value-at path (make-point (hasheq 't t) 0) A))
  (and (value? v) (value->exact v A)))

;; The first of the times near which the path has no value, jumps or turns; or #f.  A
;; smooth path has q(t+h) - 2q(t) + q(t-h) of the order h², so that the quotient by h is
;; small.
(define h (expt 2 -20))
(define (kink-near path times)
  (for/first ([t (in-list times)]
              #:unless (smooth-near? path t))
    t))

;; A jump may be as high on one side as on the other.
(define (smooth-near? path t)
  (define d (second-difference path t h))
  (and d
       (< (abs (/ d h)) 1/100)
       (< (abs (- (path-value path (+ t h)) (path-value path t))) 1/100)))

(define (second-difference path t h)
  (define-values (a b c)
    (values (path-value path (- t h)) (path-value path t) (path-value path (+ t h))))
  (and a b c (+ a (* -2 b) c)))

;; |q'' - force| at t, to about 10^-20; or #f
(define k (expt 2 -80))
(define (residual-size path force t)
  (define d (second-difference path t k))
  (define q (and d (path-value path t)))
  (and q (abs (- (/ d (* k k))
                 (case force [(none) 0] [(constant) -1] [else (- q)])))))
