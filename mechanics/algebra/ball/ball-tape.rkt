#lang racket/base
;; The real value of an expression, exactly or within a ball: it has one where each of its
;; items has.

(require "ball-value.rkt"
         "../expression/flat-graph.rkt" "../expression/operation.rkt" "../expression/pi.rkt")

(provide tape-value)

;; lookup : leaf values-of-its-arguments -> exact rational; of a tuple, the value is a list of
;; its name and its components' values
;; p : the precision in bits
;; -> a value, 'no-value where some item has none, or 'unknown
(define (tape-value t lookup p)
  (with-handlers ([symbol? values])
    (define items (tape-items t))
    (define so-far (make-vector (vector-length items) #f))
    (define met (make-hasheq))
    (for/last ([head (in-vector (tape-heads t))] [ks (in-vector (tape-operands t))]
               [k (in-naturals)])
      (define v (item-value (vector-ref items k) head (values-of ks so-far) lookup p met))
      (vector-set! so-far k v)
      v)))

(define (values-of ks so-far)
  (if (null? ks)
      '()
      (cons (vector-ref so-far (car ks)) (values-of (cdr ks) so-far))))

(define (item-value e head arguments lookup p met)
  (cond [(operation? head) (apply-operation head arguments p met)]
        [head (lookup e arguments)]
        [(pi-multiple e) => (lambda (k) (pi->value k p))]
        [(symbol? e) (lookup e '())]
        [else (number->value e p)]))
