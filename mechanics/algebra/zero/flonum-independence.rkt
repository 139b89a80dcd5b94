#lang racket/base
;; Proofs that hold whatever the flonums of an expression are.
;;
;; That an expression vanishes tells little: its flonums may be rounded results of others,
;; as in 0.1 + 0.2 - 0.30000000000000004.  Hence each is replaced by an unknown, the same
;; for a number and its negative.  If the expression vanishes then, it does for any g in
;; place of 9.8, and rounding has no part in it.  Combinations of numbers alone, as 2 · 4.9
;; makes 9.8, are Racket's arithmetic and done before an expression is made; so
;; expressions without a symbol prove nothing.

(require "decimal-readings.rkt" "proof.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/symbols.rkt")

(provide contains-flonum? speaks-of-symbols? vanishes-for-any-flonums?)

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? t)
  (for/or ([e (in-vector (tape-items t))]) (and (number? e) (not (exact? e)))))

;; A : assumptions.  The proof may not rest on values of the unknowns.
(define (vanishes-for-any-flonums? t A)
  (define unknowns (make-hasheqv))
  (define (general)
    (with-decimals-read (tape->expression t)
                        (for/list ([x (in-list (decimals-in t))])
                          (reading x (unknown x unknowns)))))
  (define grounds
    (and (speaks-of-symbols? t)
         (prove-vanishing (expression->tape (general)) A)))
  (and grounds
       (not (datum-mentions? grounds (lambda (x) (memq x (hash-values unknowns)))))))

(define (speaks-of-symbols? t)
  (for/or ([e (in-vector (tape-items t))])
    (or (free-symbol? e) (and (node? e) (null? (node-args e))))))

(define (unknown x unknowns)
  (define below? (and (real? x) (negative? x)))
  (define symbol
    (hash-ref! unknowns (if below? (- x) x) (lambda () (string->uninterned-symbol "c"))))
  (if below? (e:negate symbol) symbol))
