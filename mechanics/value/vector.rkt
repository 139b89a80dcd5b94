#lang racket/base
;; Racket's access to vectors, for tuples too: the book treats tuples as the
;; vectors they are in Scheme (SICM p. 96).

(require "../generic/up-down.rkt")

(provide tuple-vector-ref tuple-vector-length)

(define tuple-vector-ref
  (let ([vector-ref (lambda (v i) (if (structure? v) (structure-ref v i) (vector-ref v i)))])
    vector-ref))

(define tuple-vector-length
  (let ([vector-length (lambda (v) (if (structure? v) (structure-length v) (vector-length v)))])
    vector-length))
