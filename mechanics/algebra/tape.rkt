#lang racket/base
;; Tapes: an expression's graph written out once, operands before the nodes they
;; are operands of.
;;
;; A walk over a tape is a loop over vectors by place, without a table of nodes
;; met; so an expression to be evaluated several times is put on a tape first.

(require "expression.rkt" "operation.rkt")

(provide (struct-out tape) expression->tape tape-length merge-equal-items)

;; items : vector of numbers, symbols and nodes, the whole expression last
;; operands : vector of lists of places, those of the operands of each node
(struct tape (items operands) #:authentic)

(define (tape-length t) (vector-length (tape-items t)))

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

;; ---------------------------------------------------------------------------

;; The tape without nodes that do as others before them, with the same head and
;; the same operands in any order they may have.
(define (merge-equal-items t)
  (define n (tape-length t))
  (define places (make-hash))
  (define new-places (make-vector n))
  (define-values (items operands count)
    (for/fold ([items '()] [operands '()] [count 0])
              ([e (in-vector (tape-items t))] [ks (in-vector (tape-operands t))] [k (in-naturals)])
      (define new-ks (for/list ([j (in-list ks)]) (vector-ref new-places j)))
      (define key (item-key e new-ks))
      (define known (hash-ref places key #f))
      (vector-set! new-places k (or known count))
      (cond [known (values items operands count)]
            [else
             (hash-set! places key count)
             (values (cons e items) (cons new-ks operands) (+ count 1))])))
  (tape (reversed-vector items count) (reversed-vector operands count)))

(define (item-key e ks)
  (cond [(not (node? e)) e]
        [else
         (define head (node-head e))
         (cons (if (literal-head? head)
                   (cons (literal-head-name head) (literal-head-index head))
                   head)
               (if (memq head (list op:+ op:*)) (sort ks <) ks))]))
