#lang racket/base
;; Tapes: an expression's graph written out once, operands before the nodes they
;; are operands of.
;;
;; A walk over a tape is a loop over vectors by place, without a table of nodes
;; met; so an expression to be evaluated several times is put on a tape first.

(require "expression.rkt")

(provide (struct-out tape) expression->tape)

;; items : vector of numbers, symbols and nodes, the whole expression last
;; operands : vector of lists of places, those of the operands of each node
(struct tape (items operands) #:authentic)

(define (expression->tape e)
  (define places (make-hasheq))
  (define items '())
  (define operands '())
  (define count 0)
  (define (append! e ks)
    (define k count)
    (set! items (cons e items))
    (set! operands (cons ks operands))
    (set! count (+ k 1))
    (hash-set! places e k)
    k)
  (define (place e)
    (cond [(hash-ref places e #f)]
          [(node? e) (append! e (places-of (node-args e)))]
          [else (append! e '())]))
  (define (places-of es)
    (if (null? es)
        '()
        (let ([k (place (car es))])
          (cons k (places-of (cdr es))))))
  (place e)
  (tape (reversed-vector items count) (reversed-vector operands count)))

(define (reversed-vector items count)
  (define v (make-vector count))
  (let loop ([items items] [k (- count 1)])
    (unless (null? items)
      (vector-set! v k (car items))
      (loop (cdr items) (- k 1))))
  v)
