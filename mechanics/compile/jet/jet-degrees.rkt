#lang racket/base
;; Which nodes of a graph are polynomials in the time, of which degree.

(require "jet-graph.rkt" "jet-nodes.rkt")

(provide node-degrees)

;; slopes : the ids of the rates of the first inputs, or #f if nothing is known of these
;; -> vector of exact integers, +inf.0 for what is none.  An input of degree d + 1 has a rate of
;; degree d, so that degrees are found by repetition.
(define (node-degrees g slopes)
  (let loop ([inputs (make-vector (graph-varying g) +inf.0)])
    (define degrees (degrees-from g inputs))
    (define better
      (for/vector ([d (in-vector inputs)] [k (in-naturals)])
        (if slopes (lower d (+ 1 (vector-ref degrees (vector-ref slopes k)))) d)))
    (if (equal? better inputs)
        degrees
        (loop (for/vector ([d (in-vector better)]) (if (> d greatest) +inf.0 d))))))

;; Degrees are exact, as indices are; `min` of one and infinity would not be.
(define (lower d e) (if (< e d) e d))

;; Longer polynomials are treated as if they did not end.
(define greatest 4)

(define (degrees-from g inputs)
  (define nodes (graph-nodes g))
  (define degrees (make-vector (vector-length nodes) +inf.0))
  (define (degree id) (vector-ref degrees id))
  (for ([n (in-vector nodes)] [id (in-naturals)])
    (vector-set!
     degrees id
     (bounded
      (case (node-kind n)
        [(input) (if (< id (vector-length inputs)) (vector-ref inputs id) 0)]
        [(one) 0]
        [(linear) (for/fold ([d 0]) ([x (in-list (node-operands n))]) (max d (degree x)))]
        [(product) (+ (degree (cadr n)) (degree (caddr n)))]
        [else (if (for/and ([x (in-list (node-operands n))]) (eqv? 0 (degree x))) 0 +inf.0)]))))
  degrees)

(define (bounded d) (if (> d greatest) +inf.0 d))
