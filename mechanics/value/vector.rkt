#lang racket/base
;; Racket's access to vectors, for tuples too: the book treats tuples as the
;; vectors they are in Scheme (SICM p. 96).

(require "../generic/structure.rkt")

(provide tuple-vector-ref tuple-vector-length)

(define (elements x) (if (structure? x) (structure-elements x) x))

(define tuple-vector-ref
  (let ([vector-ref (lambda (v i) (vector-ref (elements v) i))])
    vector-ref))

(define tuple-vector-length
  (let ([vector-length (lambda (v) (vector-length (elements v)))])
    vector-length))
