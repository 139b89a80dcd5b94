#lang racket/base
;; Vectors of values of any kind, mapped.  The lengths that mechanics is made of are spelled
;; out, for speed; racket/vector would be long to load.

(provide vector-map vector-map2)

(define (vector-map f v)
  (define n (vector-length v))
  (case n
    [(2) (vector (f (vector-ref v 0)) (f (vector-ref v 1)))]
    [(3) (vector (f (vector-ref v 0)) (f (vector-ref v 1)) (f (vector-ref v 2)))]
    [else (build-vector n (lambda (i) (f (vector-ref v i))))]))

;; Of two vectors of one length.
(define (vector-map2 f v w)
  (define n (vector-length v))
  (case n
    [(2) (vector (f (vector-ref v 0) (vector-ref w 0))
                 (f (vector-ref v 1) (vector-ref w 1)))]
    [(3) (vector (f (vector-ref v 0) (vector-ref w 0))
                 (f (vector-ref v 1) (vector-ref w 1))
                 (f (vector-ref v 2) (vector-ref w 2)))]
    [else (build-vector n (lambda (i) (f (vector-ref v i) (vector-ref w i))))]))
