#lang racket/base
;; The symbols that stand for values in an expression, in alphabetical order.  The names
;; of functions that are applied in it are not among them, nor is :pi, which is a number.

(require "expression.rkt" "operation.rkt" "pi.rkt")

(provide symbols-in occurs? unknown? free-symbol?)

;; Does e stand for a value by itself, as a symbol does or a literal function applied?
(define (unknown? e)
  (or (free-symbol? e) (and (node? e) (literal-head? (node-head e)))))

(define (free-symbol? e) (and (symbol? e) (not (pi-symbol? e))))

(define (symbols-in e)
  (define found (make-hasheq))
  (node-fold e (lambda (leaf) (when (free-symbol? leaf) (hash-set! found leaf #t))) void)
  (sort (hash-keys found) symbol<?))

(define (occurs? name e) (some-leaf? (lambda (leaf) (eq? leaf name)) e))
