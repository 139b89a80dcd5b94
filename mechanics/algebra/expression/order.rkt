#lang racket/base
;; One total order on expressions, for choosing and for showing.
;;
;; Numbers, then symbols by the alphabet, then compound algebra (a sum under a
;; function, say), then literal functions, then known functions, then
;; derivatives by order; shorter sums and products before longer ones.  Equal
;; expressions compare as 0, in whatever order their operands were written.  An
;; order remembers the sorted operands of the sums and products it has met, so
;; that sorting costs the graph.

(require "expression.rkt" "operation.rkt")

(provide make-order expression<? expression-compare derivative-order)

;; (make-order) -> (a b -> negative, 0 or positive)
(define (make-order)
  (define sorted (make-memo))
  (define (compare a b)
    (cond [(eq? a b) 0]
          [(and (symbol? a) (symbol? b)) (compare-symbols a b)]
          [else
           (define k (- (rank a) (rank b)))
           (cond [(not (eq? k 0)) k]
                 [(number? a) (compare-numbers a b)]
                 [(expression=? a b) 0]
                 [else (compare-nodes a b)])]))
  (define (compare-nodes a b)
    (define k (compare-heads (node-head a) (node-head b)))
    (cond [(not (eq? k 0)) k]
          [(commutative? (node-head a))
           (define d (- (length (node-args a)) (length (node-args b))))
           (if (eq? d 0) (compare-lists compare (operands a) (operands b)) d)]
          [else (compare-lists compare (node-args a) (node-args b))]))
  (define (operands n)
    (sorted n (lambda () (sort (node-args n) before?))))
  (define (before? a b) (< (compare a b) 0))
  compare)

(define (expression-compare a b) ((make-order) a b))
(define (expression<? a b) (< (expression-compare a b) 0))

;; By the first elements that differ; compare : (a b -> negative, 0 or positive)
(define (compare-lists compare as bs)
  (cond [(null? as) (if (null? bs) 0 -1)]
        [(null? bs) 1]
        [else
         (define k (compare (car as) (car bs)))
         (if (eq? k 0) (compare-lists compare (cdr as) (cdr bs)) k)]))

;; ---------------------------------------------------------------------------
;; Kinds

(define (rank e)
  (cond [(number? e) 0]
        [(symbol? e) 1]
        [else
         (define head (node-head e))
         (cond [(literal-head? head) (if (null? (literal-head-index head)) 3 5)]
               [(memq head (list op:+ op:- op:* op:/)) 2]
               [else 4])]))

;; How many times the function at the head of e is differentiated.
(define (derivative-order e)
  (if (and (node? e) (literal-head? (node-head e))) (order-of (node-head e)) 0))

(define (compare-heads a b)
  (cond [(eq? a b) 0]
        [(and (operation? a) (operation? b))
         (compare-symbols (operation-name a) (operation-name b))]
        [(operation? a) -1]
        [(operation? b) 1]
        [else (compare-literals a b)]))

(define (compare-literals a b)
  (define k (- (order-of a) (order-of b)))
  (define names (compare-symbols (literal-head-name a) (literal-head-name b)))
  (cond [(not (eq? k 0)) k]
        [(not (eq? names 0)) names]
        [else (compare-lists compare-entries (literal-head-index a) (literal-head-index b))]))

(define (order-of head)
  (for/sum ([entry (in-list (literal-head-index head))]) (cdr entry)))

;; Entries (path . count) of multi-indices
(define (compare-entries a b)
  (define (numbers entry) (append (car entry) (list (- (cdr entry)))))
  (compare-lists - (numbers a) (numbers b)))

;; ---------------------------------------------------------------------------
;; Leaves

(define (compare-symbols a b)
  (if (eq? a b) 0 (if (symbol<? a b) -1 1)))

(define (compare-numbers a b)
  (define k (compare-reals (real-part a) (real-part b)))
  (if (eqv? k 0) (compare-reals (imag-part a) (imag-part b)) k))

(define (compare-reals a b)
  (cond [(eqv? a b) 0]
        [(< a b) -1]
        [(> a b) 1]
        [(and (exact? a) (inexact? b)) -1]
        [(and (inexact? a) (exact? b)) 1]
        [(eqv? a +nan.0) 1]
        [(eqv? b +nan.0) -1]
        [else (if (eqv? a -0.0) -1 1)]))
