#lang racket/base
;; Numbers as trees: signs are those of sums, quotients fractions, and exponents of flonums
;; powers of ten.

(require "tree.rkt")

(provide number->tree decimal->tree negated negative-body)

;; t -> −t; and a negative -> the tree that it is the negative of, #f of other trees.  A negative
;; is a sum of one term.
(define (negated t)
  (cond [(negative-body t) => values]
        [(or (sum? t) (relation? t)) (negated (parenthesized t))]
        [else (sum (list (term #t t)))]))

(define (negative-body t)
  (and (sum? t)
       (null? (cdr (sum-terms t)))
       (term-negative? (car (sum-terms t)))
       (term-body (car (sum-terms t)))))

(define (number->tree x)
  (cond [(not (real? x)) (complex->tree x)]
        [(or (< x 0) (eqv? x -0.0) (eqv? x -0.0f0)) (negated (magnitude->tree (- x)))]
        [else (magnitude->tree x)]))

(define (magnitude->tree x)
  (cond [(exact-integer? x) (digits (number->string x))]
        [(exact? x) (fraction (digits (number->string (numerator x)))
                              (digits (number->string (denominator x))))]
        [(eqv? x +inf.0) (word "∞")]
        [(not (= x x)) (word "NaN")]
        [else (decimal->tree (number->string x))]))

;; "6.67e-11", "-0.5"
(define (decimal->tree text)
  (define m (regexp-match #rx"^(-?)([0-9.]+)(?:e([-+]?[0-9]+))?$" text))
  (define number
    (cond [(not m) (plain text)]
          [(cadddr m) (scientific (caddr m) (string->number (cadddr m)))]
          [else (digits (caddr m))]))
  (if (and m (string=? "-" (cadr m))) (negated number) number))

(define (complex->tree z)
  (define re (real-part z))
  (define im (number->tree (imag-part z)))
  (define body (negative-body im))
  (define last-term (term (and body #t) (imaginary (or body im))))
  (cond [(not (eqv? re 0)) (sum (list (first-term (number->tree re)) last-term))]
        [body (sum (list last-term))]
        [else (imaginary im)]))

(define (first-term t)
  (define body (negative-body t))
  (term (and body #t) (or body t)))
