#lang racket/base
;; An expression as a function of some of its symbols, over the generic arithmetic:
;; of numbers, expressions, and the values that derivatives are taken with.

(require "derivative.rkt" "literal-function.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../error/computed-once.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/kind.rkt"
         "../generic/up-down.rkt"
         "../value/shape.rkt")

(provide evaluate-generically evaluate-at expression-derivative apply-generically)

;; The value of e with values in place of symbols, ((symbol . value) ...).
(define (evaluate-generically e point)
  (node-fold e
             (lambda (leaf)
               (define entry (and (symbol? leaf) (assq leaf point)))
               (if entry (cdr entry) leaf))
             (lambda (n arguments) (apply-generically (node-head n) arguments))))

;; The value of `formula`, an expression or a structure of them in the symbols of `place`, where
;; these have the values that stand in their places in `at`, a structure of the same shape.
(define (evaluate-at formula place at)
  (define point (map cons (scalars place) (scalars at)))
  (s:map/r (lambda (e) (evaluate-generically e point)) formula))

(define (apply-generically head arguments)
  (cond [(literal-head? head) (apply-head head arguments)]
        [(eq? head op:up) (apply up arguments)]
        [(eq? head op:down) (apply down arguments)]
        [else (apply (generic-procedure head (length arguments)) arguments)]))

;; Of as many arguments: atan has two procedures.
(define (generic-procedure head n)
  (for/first ([procedure (in-list (hash-ref (procedures-by-operation) head '()))]
              #:when (procedure-arity-includes? procedure n))
    procedure))

(define procedures-by-operation
  (once
   (lambda ()
     (for*/fold ([table (hasheq)])
                ([os (in-list (list elementary-operations arithmetic-operations))]
                 [o (in-list os)])
       (hash-update table (generic-op-operation o)
                    (lambda (others) (cons (generic-op-procedure o) others)) '())))))

;; ∂e/∂x, an expression
(define (expression-derivative e x)
  (derivative-at (lambda (value) (evaluate-generically e (list (cons x value)))) x))
