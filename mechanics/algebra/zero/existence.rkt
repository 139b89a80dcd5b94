#lang racket/base
;; Has an expression a value anywhere?
;;
;; What is nowhere defined equals anything: 1/z with z = 0, however z is written, and
;; log(-1 - x²).  So a proof asks for a point where every part of the expression as it was
;; given has a value, and where what was declared holds.

(require "assignment.rkt" "../ball/ball-tape.rkt" "point-value.rkt"
         (only-in "../assumption/assumption-set.rkt" assumptions-relations)
         (only-in "../assumption/reference.rkt" find-reference)
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt" "../expression/symbols.rkt")

(provide somewhere-defined? everywhere-defined? decisive-leaves)

;; t : tape; A : assumptions
(define (somewhere-defined? t A)
  (or (everywhere-defined? t)
      (and (null? (assumptions-relations A)) (defined-among-positive? t))
      (let ([value (if (contains-complex? t) complex-value tape-value)])
        (and (find-reference (list (tape->expression t)) A
                             (lambda (lookup) (defined? t lookup value)))
             #t))))

;; Has it a value where all leaves are positive, as √(k/m) does?  Then it is divided by what is
;; made of its leaves and positive numbers without a minus sign, and so are its radicands and
;; the arguments of its logarithms.  Unknown functions may have any values, positive ones too.
(define (defined-among-positive? t)
  (define n (tape-length t))
  (define positive (make-vector n #f))
  (for/and ([e (in-vector (tape-items t))] [ks (in-vector (tape-operands t))] [k (in-naturals)])
    (define (positive-operand? k) (vector-ref positive k))
    (vector-set! positive k
                 (cond [(number? e) (and (real? e) (rational? e) (positive? e))]
                       [(or (symbol? e) (unknown? e)) #t]
                       [else (and (memq (node-head e) keep-positive)
                                  (andmap positive-operand? ks))]))
    (cond [(number? e) (and (real? e) (rational? e))]
          [(or (symbol? e) (total? e)) #t]
          [(eq? (node-head e) op:/) (positive-operand? (cadr ks))]
          [(memq (node-head e) (list op:sqrt op:log op:expt)) (positive-operand? (car ks))]
          [else #f])))

;; Of positive arguments they are positive.
(define keep-positive (list op:+ op:* op:/ op:sqrt op:expt op:exp op:cosh op:sinh op:tanh op:abs))

;; Polynomials in sines, exponentials and the like.
(define (everywhere-defined? t)
  (for/and ([e (in-vector (tape-items t))])
    (cond [(node? e) (total? e)]
          [(number? e) (rational? (magnitude e))]
          [else #t])))

(define (total? n)
  (or (literal-head? (node-head n))
      (and (memq (node-head n) total) #t)
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
