#lang racket/base
;; The factors of an expression, and those that vanish where it does.

(require racket/list
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../rewriting/factor.rkt")

(provide expression-factors vanishing-factors)

(define (vanishing-factors e A)
  (for/list ([f (in-list (expression-factors e A))] #:when (positive? (cdr f))) (car f)))

;; ((factor . exponent) ...), their product being e
(define (expression-factors e A)
  (define-values (product grounds) (factored-expression e A))
  (let walk ([e product] [power 1])
    (define args (if (node? e) (node-args e) '()))
    (define head (and (node? e) (node-head e)))
    (cond [(eq? head op:*) (append-map (lambda (a) (walk a power)) args)]
          [(eq? head op:/) (append (walk (car args) power) (walk (cadr args) (- power)))]
          [(and (eq? head op:expt) (exact-integer? (cadr args)))
           (walk (car args) (* power (cadr args)))]
          [else (list (cons e power))])))
