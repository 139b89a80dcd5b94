#lang racket/base
;; Has an expression a value anywhere?
;;
;; What is nowhere defined equals anything: 1/z with z = 0, however z is written, and
;; log(-1 - x²).  So a proof asks for a point where every part of the expression as it was
;; given has a value, and where what was declared holds.

(require "assignment.rkt" "ball-tape.rkt" "point-value.rkt"
         (only-in "../assumption/reference.rkt" find-reference)
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt" "../expression/symbols.rkt")

(provide somewhere-defined? everywhere-defined? decisive-leaves)

;; t : tape; A : assumptions
(define (somewhere-defined? t A)
  (or (everywhere-defined? t)
      (let ([value (if (contains-complex? t) complex-value tape-value)])
        (and (find-reference (list (tape->expression t)) A
                             (lambda (lookup) (defined? t lookup value)))
             #t))))

;; Polynomials in sines, exponentials and the like.
(define (everywhere-defined? t)
  (for/and ([e (in-vector (tape-items t))])
    (or (not (node? e)) (total? e))))

(define (total? n)
  (or (literal-head? (node-head n))
      (memq (node-head n) total)
      (integer-power-above-0? n)))

(define total
  (list op:+ op:- op:* op:up op:down op:sin op:cos op:exp op:sinh op:cosh op:tanh op:asinh op:abs))

(define (integer-power-above-0? e)
  (and (eq? (node-head e) op:expt) (exact-nonnegative-integer? (cadr (node-args e)))))

;; The leaves that stand where not every number may: in a denominator, under a root, a
;; logarithm, ...  -> table: leaf -> #t
(define (decisive-leaves t)
  (define items (tape-items t))
  (define n (vector-length items))
  (define decisive (make-vector n #f))
  (for/fold ([leaves (hash)]) ([k (in-range (- n 1) -1 -1)])
    (define e (vector-ref items k))
    (define decides? (vector-ref decisive k))
    (for ([j (in-list (vector-ref (tape-operands t) k))] [i (in-naturals)])
      (when (or decides? (decided-by? e i)) (vector-set! decisive j #t)))
    (if (and decides? (unknown? e)) (hash-set leaves e #t) leaves)))

;; Does the i-th argument of the node decide whether it has a value?
(define (decided-by? n i)
  (not (or (total? n) (and (eq? (node-head n) op:/) (eqv? i 0)))))

;; Has each part of it a value there?  Literal functions have one for equal arguments.
(define (defined? t lookup value)
  (define seen (make-assignment))
  (define (number leaf arguments)
    (assigned seen leaf arguments (lambda () (inexact->exact (lookup leaf '())))))
  (not (symbol? (value t number precision))))

(define precision 80)
