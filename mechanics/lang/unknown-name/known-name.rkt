#lang racket/base
;; What the prompt knows of a name.

(require (only-in "../../generic/up-down.rkt" tuple?))

(provide known-name? function-name?)

(define (known-name? name)
  (or (and (identifier-binding (namespace-symbol->identifier name)) #t)
      (not (eq? (namespace-variable-value name #f (lambda () nothing)) nothing))))

(define nothing (string->uninterned-symbol "nothing"))

;; Is it a function that the prompt has?
(define (function-name? name)
  (define x (namespace-variable-value name #t (lambda () #f)))
  (and (procedure? x) (not (tuple? x))))
