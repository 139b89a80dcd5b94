#lang racket/base
;; Vectors of complex numbers: their inner product w*z, linear in the second, and lengths.

(require "vector-map.rkt")

(provide conjugate inner norm times vector-sum conjugated)

(define (conjugate a) (make-rectangular (real-part a) (- (imag-part a))))

(define (inner w z) (for/sum ([a (in-vector w)] [b (in-vector z)]) (* (conjugate a) b)))
(define (norm v) (sqrt (real-part (inner v v))))

(define (conjugated v) (vector-map conjugate v))
(define (times c v) (vector-map (lambda (x) (* c x)) v))
(define (vector-sum v w) (vector-map2 + v w))
