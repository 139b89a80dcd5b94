#lang racket/base
;; The symbols that stand for values in an expression, in alphabetical order.  The names
;; of functions that are applied in it are not among them.

(require "expression.rkt")

(provide symbols-in occurs?)

(define (symbols-in e)
  (define found (make-hasheq))
  (node-fold e (lambda (leaf) (when (symbol? leaf) (hash-set! found leaf #t))) void)
  (sort (hash-keys found) symbol<?))

(define (occurs? name e)
  (node-fold e (lambda (leaf) (eq? leaf name)) (lambda (n found) (ormap values found))))
