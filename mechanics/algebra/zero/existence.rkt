#lang racket/base
;; Has an expression a value anywhere?
;;
;; What is nowhere defined equals anything: 1/z with z = 0, however z is written, and
;; log(-1 - x²).  So a proof asks for a point where every part of the expression as it was
;; given has a value, and where what was declared holds.

(require "assignment.rkt" "ball-tape.rkt" "point-value.rkt"
         (only-in "../assumption/reference.rkt" find-reference)
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt")

(provide somewhere-defined? everywhere-defined?)

;; t : tape; A : assumptions
(define (somewhere-defined? t A)
  (or (everywhere-defined? t)
      (let ([value (if (contains-complex? t) complex-value tape-value)])
        (and (find-reference (list (tape->expression t)) A
                             (lambda (lookup) (defined? t lookup value)))
             #t))))

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

;; Has each part of it a value there?  Literal functions have one for equal arguments.
(define (defined? t lookup value)
  (define seen (make-assignment))
  (define (number leaf arguments)
    (assigned seen leaf arguments (lambda () (inexact->exact (lookup leaf '())))))
  (not (symbol? (value t number precision))))

(define precision 80)
