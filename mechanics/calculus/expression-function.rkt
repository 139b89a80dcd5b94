#lang racket/base
;; An expression as a function of some of its symbols, over the generic arithmetic:
;; of numbers, expressions, and what derivatives are taken with.

(require "derivative.rkt" "literal-function.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
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
  (for/first ([o (in-sequences arithmetic-operations elementary-operations)]
              #:when (and (eq? (generic-op-operation o) head)
                          (procedure-arity-includes? (generic-op-procedure o) n)))
    (generic-op-procedure o)))

;; ∂e/∂x, an expression
(define (expression-derivative e x)
  (derivative-at (lambda (value) (evaluate-generically e (list (cons x value)))) x))
