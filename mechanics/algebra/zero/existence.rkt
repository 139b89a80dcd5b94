#lang racket/base
;; Has an expression a value anywhere?
;;
;; What is nowhere defined equals anything: 1/z with z = 0, however z is written, and
;; log(-1 - x²).  So a proof asks for a point where every part of the expression as it was
;; given has a value, and where what was declared holds.

(require "approximate.rkt"
         "../assumption/reference.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt")

(provide somewhere-defined?)

;; t : tape; A : assumptions
(define (somewhere-defined? t A)
  (or (everywhere-defined? t)
      (let ([real? (andmap real-or-symbolic? (vector->list (tape-items t)))])
        (and (find-reference (list (tape->expression t)) A
                             (lambda (lookup) (defined? t lookup real?)))
             #t))))

(define (real-or-symbolic? e) (or (not (number? e)) (real? e)))

;; Polynomials in sines, exponentials and the like.
(define (everywhere-defined? t)
  (for/and ([e (in-vector (tape-items t))])
    (or (not (node? e))
        (literal-head? (node-head e))
        (memq (node-head e) total)
        (integer-power-above-0? e))))

(define total
  (list op:+ op:- op:* op:up op:down op:sin op:cos op:exp op:sinh op:cosh op:tanh op:asinh op:abs))

(define (integer-power-above-0? e)
  (and (eq? (node-head e) op:expt) (exact-nonnegative-integer? (cadr (node-args e)))))

;; Is each part of it a finite number there, and a real one where that is asked for?
(define (defined? t lookup real?)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
    (define-values (value error) (approximate-tape t lookup (and real? void)))
    (and (rational? (magnitude value)) (rational? error))))
