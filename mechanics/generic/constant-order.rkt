#lang racket/base
;; Which of two constants is greater, where π is in one: not by flonums, which are equal for
;; π and its first sixteen digits, and have few digits left where large numbers cancel.

(require "on-demand.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../error/complain.rkt")

(require-on-demand ["../algebra/simplify/simplify-expression.rkt" simplify-expression]
                   ["../algebra/zero/constant-bounds.rkt" constant-bounds])

(provide constant-order)

;; a, b : real numbers, or expressions that constant-value knows -> the sign of a − b
(define (constant-order who a b)
  (cond [(and (rational-constant? a) (rational-constant? b))
         (sign-of who (e:- (exactly a) (exactly b)))]
        [else (order (flonum-of a) (flonum-of b))]))      ; one is infinite, or no number

(define (rational-constant? x) (or (not (number? x)) (rational? x)))
(define (exactly x) (if (number? x) (inexact->exact x) x))
(define (flonum-of x) (if (number? x) x (constant-value x)))

;; #f if one is no number
(define (order a b) (cond [(< a b) -1] [(> a b) 1] [(= a b) 0] [else #f]))

;; Bounds that zero is not between; if none are, it is zero by its form.
(define (sign-of who e)
  (define (sign low high) (cond [(> low 0) 1] [(< high 0) -1] [else #f]))
  (cond [(real? e) (order e 0)]
        [(constant-bounds e sign)]
        [else
         (define simple (simplify-expression e))
         (if (real? simple)
             (order simple 0)
             (complain who "two constants are too close to be told apart by their decimals"))]))
