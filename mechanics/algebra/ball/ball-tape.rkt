#lang racket/base
;; The real value of an expression, exactly or within a ball: it has one where each of its
;; items has.

(require "ball-value.rkt"
         "../expression/flat-graph.rkt" "../expression/operation.rkt" "../expression/pi.rkt")

(provide tape-value evaluate-tape)

;; lookup : leaf values-of-its-arguments -> exact rational; of a tuple, the value is a list of
;; its name and its components' values
;; p : the precision in bits
;; -> a value, 'no-value where some item has none, or 'unknown
(define (tape-value t lookup p)
  (with-handlers ([symbol? values])
    (define met (make-hasheq))
    (evaluate-tape t (lambda (e head arguments) (item-value e head arguments lookup p met)))))

;; value-of : item, its head and the values of its operands -> its value
;; -> the value of the last item
(define (evaluate-tape t value-of)
  (define known (make-vector (tape-length t) #f))
  (define (values-at ks)
    (if (null? ks) '() (cons (vector-ref known (car ks)) (values-at (cdr ks)))))
  (for/last ([e (in-vector (tape-items t))] [head (in-vector (tape-heads t))]
             [ks (in-vector (tape-operands t))] [k (in-naturals)])
    (define v (value-of e head (values-at ks)))
    (vector-set! known k v)
    v))

(define (item-value e head arguments lookup p met)
  (cond [(operation? head) (apply-operation head arguments p met)]
        [head (lookup e arguments)]
        [(pi-multiple e) => (lambda (k) (pi->value k p))]
        [(symbol? e) (lookup e '())]
        [else (number->value e p)]))
