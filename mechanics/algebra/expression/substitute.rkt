#lang racket/base
;; Expressions for parts of expressions, at the cost of the graph.

(require "expression.rkt" "operation.rkt")

(provide substitute-expression in-place-of with-sign rebuild)

;; e with each key of the alist, a symbol or any expression, replaced by its
;; value wherever an equal expression stands.  Nodes around it are made anew by `rebuild`.
(define (substitute-expression e replacements [rebuild rebuild])
  (define table (make-hash replacements))
  (define memo (make-memo))
  (let walk ([e e])
    (cond [(hash-ref table e #f)]
          [(node? e)
           (memo e (lambda ()
                     (define args (map walk (node-args e)))
                     (if (andmap eq? args (node-args e))
                         e
                         (rebuild (node-head e) args))))]
          [else e])))

;; The same, nothing being evaluated: log(1 − 2) stays as it is.
(define (in-place-of replacements e) (substitute-expression e replacements make-node))

;; e where sgn u = sign
(define (with-sign e u sign)
  (substitute-expression e (list (cons (make-node op:abs (list u)) (e:* sign u))
                                 (cons (make-node op:sgn (list u)) sign))))

;; The head applied to expressions, by the constructors.
(define (rebuild head args)
  (cond [(literal-head? head) (make-node head args)]
        [(eq? head op:+) (for/fold ([sum 0]) ([a (in-list args)]) (e:+ sum a))]
        [(eq? head op:*) (for/fold ([product 1]) ([a (in-list args)]) (e:* product a))]
        [(eq? head op:-) (e:- (car args) (cadr args))]
        [(eq? head op:/) (e:/ (car args) (cadr args))]
        [(eq? head op:expt) (e:expt (car args) (cadr args))]
        [else (apply e:apply head args)]))
