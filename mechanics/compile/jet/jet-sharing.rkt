#lang racket/base
;; Which products of a graph are computed together, in one loop.

(require "jet-graph.rkt" "jet-nodes.rkt")

(provide sole-uses factor-groups)

;; 'sum of products that only one sum is made of, which are added up there; else #f.
(define (sole-uses g)
  (define nodes (graph-nodes g))
  (define counts (make-vector (vector-length nodes) 0))
  (define in-sums (make-vector (vector-length nodes) 0))
  (define (count! v id) (vector-set! v id (+ 1 (vector-ref v id))))
  (for ([n (in-vector nodes)])
    (for ([id (in-list (node-operands n))])
      (count! counts id)
      (when (eq? 'linear (node-kind n)) (count! in-sums id))))
  (for ([id (in-vector (graph-outputs g))]) (count! counts id))
  (for/vector ([n (in-vector nodes)] [count (in-vector counts)] [in-sum (in-vector in-sums)])
    (and (eq? 'product (node-kind n)) (= 1 count in-sum) 'sum)))

;; First product of a group -> the others, that share a factor with it and have their other
;; factor by then.  Each id of the others -> 'done.
(define (factor-groups g degrees uses)
  (define nodes (graph-nodes g))
  (define groups (make-hasheqv))
  (define (free? id)
    (and (eq? 'product (node-kind (vector-ref nodes id)))
         (not (vector-ref uses id))
         (not (= (cadr (vector-ref nodes id)) (caddr (vector-ref nodes id))))
         (not (hash-ref groups id #f))
         (for/and ([x (in-list (node-operands (vector-ref nodes id)))])
           (= +inf.0 (vector-ref degrees x)))))
  (define (other id factor)
    (define xs (node-operands (vector-ref nodes id)))
    (cond [(= (car xs) factor) (cadr xs)] [(= (cadr xs) factor) (car xs)] [else #f]))
  (for ([id (in-range (vector-length nodes))] #:when (free? id))
    (define (companions factor)
      (for/list ([k (in-range (+ id 1) (vector-length nodes))]
                 #:when (free? k)
                 [x (in-value (other k factor))]
                 #:when (and x (< x id)))
        k))
    (define-values (factor most)
      (for/fold ([best #f] [most '()]) ([f (in-list (node-operands (vector-ref nodes id)))])
        (define found (companions f))
        (if (> (length found) (length most)) (values f found) (values best most))))
    (when factor
      (hash-set! groups id (cons factor most))
      (for ([k (in-list most)]) (hash-set! groups k 'done))))
  groups)
