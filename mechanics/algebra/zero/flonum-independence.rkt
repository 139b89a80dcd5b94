#lang racket/base
;; Proofs that hold whatever the flonums of an expression are.
;;
;; That an expression vanishes tells little: its flonums may be rounded results of others,
;; as in 0.1 + 0.2 - 0.30000000000000004.  Hence each is replaced by an unknown, the same
;; for a number and its negative, and for 4.9 and its double.  If the expression vanishes then,
;; it does for any g in place of 9.8, and rounding has no part in it.  Combinations of numbers
;; alone, as 3 · 4.9 makes 14.700000000000001, are Racket's arithmetic and done before an
;; expression is made; so expressions without a symbol prove nothing.

(require "decimal-readings.rkt" "proof.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/symbols.rkt")

(provide contains-flonum? speaks-of-symbols? vanishes-for-any-flonums?
         with-unknown-flonums mentions-unknown?)

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? t)
  (for/or ([e (in-vector (tape-items t))]) (and (number? e) (not (exact? e)))))

;; A : assumptions.  The proof may not rest on values of the unknowns.
(define (vanishes-for-any-flonums? t A)
  (define unknowns (make-hasheqv))
  (define (general) (with-unknown-flonums (tape->expression t) unknowns))
  (define grounds
    (and (speaks-of-symbols? t)
         (prove-vanishing (expression->tape (general)) A)))
  (and grounds (not (mentions-unknown? grounds unknowns))))

;; unknowns : a hash by value, from flonums to their symbols, which grows
(define (with-unknown-flonums e unknowns)
  (with-decimals-read e (for/list ([x (in-list (decimals-of e))])
                          (reading x (unknown x unknowns)))))

(define (mentions-unknown? datum unknowns)
  (datum-mentions? datum (lambda (x) (memq x (hash-values unknowns)))))

(define (speaks-of-symbols? t)
  (for/or ([e (in-vector (tape-items t))])
    (or (free-symbol? e) (and (node? e) (null? (node-args e))))))

;; One for x, its negative, and their products with powers of 2, which are not rounded
(define (unknown x unknowns)
  (define-values (factor part)
    (if (and (rational? x) (not (zero? x))) (binary-parts x) (values 1 x)))
  (e:* factor (hash-ref! unknowns part (lambda () (string->uninterned-symbol "c")))))

;; x = factor · part, 1 <= part < 2, the factor a power of 2 or the negative of one
(define (binary-parts x)
  (define exact (abs (inexact->exact x)))
  (define power
    (expt 2 (- (integer-length (numerator exact)) (integer-length (denominator exact)))))
  (define near (/ exact power))
  (define factor (if (< near 1) (/ power 2) power))
  (values (if (< x 0) (- factor) factor) (exact->inexact (/ exact factor))))
