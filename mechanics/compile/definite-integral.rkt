#lang racket/base
;; Definite integrals (SICM p. 17).  An integrand that is evaluated often is compiled.  Where
;; symbols are in an end or in the integrand, there is a formula if an antiderivative is found.

(require "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/note.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt"
         "../generic/operation-rule/branches.rkt" "../generic/define-plain.rkt"
         "../generic/describe.rkt"
         "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/on-demand.rkt" "../generic/irrational.rkt"
         "../generic/wrong-argument.rkt")

(require-on-demand
 ["compile-function.rkt" compile-scalar]
 ["../calculus/integral.rkt" [integrate generic:integrate]]
 ["../calculus/symbolic-integral.rkt" symbolic-integral]
 ["../verdict/prove-zero.rkt" prove-zero])

(provide definite-integral definite-integral-with-tolerance integrate
         integral-conditions verify-integral)

;; tolerance : relative to the integral of |f|; eps : the same, without a keyword, as in the book
;; report    : receives the value, a bound of its error, the number of evaluations
(define-plain (definite-integral f low high [eps 1e-10]
                                 #:tolerance [tolerance eps] #:report [report first-of-three])
  (check-no-variable f low high tolerance)
  (integrate 'definite-integral f low high tolerance #:report report))

(define-plain (definite-integral-with-tolerance f low high tolerance
                                                #:report [report first-of-three])
  (integrate 'definite-integral-with-tolerance f low high tolerance #:report report))

;; An integral is written with its variable elsewhere: ∫ sin x dx from 0 to 1
(define (check-no-variable f low high tolerance)
  (when (and (symbol? low) (not (and (real? tolerance) (< 0 tolerance 0.1))))
    (complain 'definite-integral
              (string-append "expected a function and two ends; the function says which "
                             "variable is meant: (definite-integral f ~a ~a)\n"
                             "  given: ~a, ~a and ~a after it")
              (value->text high) (value->text tolerance)
              (value->text low) (value->text high) (value->text tolerance))))

;; The same on behalf of `who`.
(define (integrate who f low high tolerance #:report [report first-of-three])
  (define formula
    (and (procedure? f)
         (or (symbolic-end? low) (symbolic-end? high) (symbolic-integrand? f low high))
         (symbolic-integral who f low high)))
  (if formula
      (report formula 0 1)
      (generic:integrate who f low high tolerance compile-scalar report)))

;; The relations under which the formula of an integral with symbols holds, but for those that
;; are declared or known.
(define (integral-conditions f low high)
  (symbolic-integral 'integral-conditions f low high (lambda (formula conditions) conditions)))

;; A verdict on whether the integral is the formula given; it rests on those conditions.
(define (verify-integral f low high claim)
  (when (or (string? claim) (pointwise? claim))
    (complain-of-argument 'verify-integral "an expression or a number as the claim" claim))
  (symbolic-integral 'verify-integral f low high
                     (lambda (formula conditions)
                       (prove-zero (g:- formula claim) #:resting-on conditions))
                     #:claim claim))

(define (symbolic-end? end)
  (define x (comparand end))
  (and (symbolic? x) (not (constant-value x))))

;; Does f have symbols of its own at a number between?
(define (symbolic-integrand? f low high)
  (define-values (from to) (values (number-or-not low) (number-or-not high)))
  (and (real? from) (real? to) (accepts? f 1)
       (let ([y (if-raised no-value? #f
                  (parameterize ([current-branches #f])
                    (without-notes (f (inner-point from to)))))])
         (symbolic-end? y))))

;; The number that an end is, also if made of π; #f with other symbols
(define (number-or-not end) (if (symbolic? end) (constant-value end) (irrational-as-decimal end)))

(define (inner-point low high)
  (cond [(and (rational? low) (rational? high)) (+ low (* 5/13 (- high low)))]
        [(rational? low) (+ low 5/13)]
        [(rational? high) (- high 5/13)]
        [else 5/13]))

(define (first-of-three value bound count) value)
