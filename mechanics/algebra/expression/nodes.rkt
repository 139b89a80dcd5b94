#lang racket/base
;; The nodes of an expression, and searches among them.

(require (only-in racket/list filter-map remove-duplicates)
         "expression.rkt" "operation.rkt")

(provide nodes-in parts-in some-node? real-leaves? divisor-of)

;; The nodes of e, each once, after those in it.
(define (nodes-in e)
  (define found '())
  (node-fold e void (lambda (n _) (set! found (cons n found))))
  (reverse found))

;; part-of : node -> part or #f
;; -> the parts of all nodes of e, each once
(define (parts-in e part-of) (remove-duplicates (filter-map part-of (nodes-in e))))

;; Does the predicate hold of some node of e?
(define (some-node? good? e)
  (node-fold e (lambda (leaf) #f) (lambda (n found) (or (ormap values found) (good? n)))))

;; Are all numbers in e real?
(define (real-leaves? e) (all-leaves? (lambda (leaf) (or (symbol? leaf) (real? leaf))) e))

;; Where the divisor is 0 the node has a pole; #f if there is none.
(define (divisor-of n)
  (define args (node-args n))
  (cond [(headed? n op:/) (cadr args)]
        [(and (headed? n op:expt) (real? (cadr args)) (negative? (cadr args))) (car args)]
        [else #f]))
