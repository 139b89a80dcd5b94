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
  (define-values (items operands count)
    (let walk ([e e] [items '()] [operands '()] [count 0])
      (cond [(hash-ref places e #f) (values items operands count)]
            [else
             (define-values (items* operands* count*)
               (for/fold ([items items] [operands operands] [count count])
                         ([a (in-list (if (node? e) (node-args e) '()))])
                 (walk a items operands count)))
             (hash-set! places e count*)
             (values (cons e items*)
                     (cons (if (node? e) (places-of places (node-args e)) '()) operands*)
                     (+ count* 1))])))
  (tape (reversed-vector items count) (reversed-vector operands count)))

(define (places-of places es)
  (if (null? es)
      '()
      (cons (hash-ref places (car es)) (places-of places (cdr es)))))

(define (reversed-vector items count)
  (define v (make-vector count))
  (let loop ([items items] [k (- count 1)])
    (unless (null? items)
      (vector-set! v k (car items))
      (loop (cdr items) (- k 1))))
  v)
