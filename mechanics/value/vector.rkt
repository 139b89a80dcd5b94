#lang racket/base
;; Racket's access to vectors, for tuples too: the book treats tuples as the
;; vectors they are in Scheme (SICM p. 96).

(require "../error/complain.rkt"
         "../generic/naming.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt")

(provide tuple-vector-ref tuple-vector-length tuple-vector->list tuple-vector-map)

(define-named tuple-vector-ref vector-ref
  (lambda (v i) (if (structure? v) (structure-ref v i) (vector-ref v i))))

(define-named tuple-vector-length vector-length
  (lambda (v) (if (structure? v) (structure-length v) (vector-length v))))

(define-named tuple-vector->list vector->list
  (lambda (v) (vector->list (if (structure? v) (structure-elements v) v))))

;; f of corresponding components; the result is of the kind of the first.
(define-named tuple-vector-map vector-map
  (lambda (f first . more)
    (define all
      (for/list ([v (in-list (cons first more))])
        (check-argument 'vector-map tuple? v "tuples or vectors")
        (tuple-elements v)))
    (unless (for/and ([v (in-list all)]) (= (vector-length v) (vector-length (car all))))
      (complain 'vector-map "the tuples differ in length: ~a" (map vector-length all)))
    (define values-of (list->vector (apply map f (map vector->list all))))
    (if (structure? first) (same-orientation first values-of) values-of)))
