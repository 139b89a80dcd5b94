#lang racket/base
;; The value of an operation and its partial derivatives, its *slopes*: the parts
;; of the chain rule in either mode.

(require racket/flonum
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/kind.rkt")

(provide value-and-slope    ; generic-op x -> value, derivative
         value-and-slopes   ; generic-op x y -> value, derivative by x, by y
         first-slope second-slope
         times)

;; Of flonums an operation gives all in one call.
(define-syntax-rule (value-and-slope op x)
  (let ([at-flonums (generic-op-at-flonums op)])
    (if (and at-flonums (flonum? x))
        (at-flonums x)
        (general-value-and-slope op x))))

(define (general-value-and-slope op x)
  (define value ((generic-op-procedure op) x))
  (values value ((first-partial op) x value)))

(define-syntax-rule (value-and-slopes op x y)
  (let ([at-flonums (generic-op-at-flonums op)])
    (if (and at-flonums (flonum? x) (flonum? y))
        (at-flonums x y)
        (general-value-and-slopes op x y))))

(define (general-value-and-slopes op x y)
  (define value ((generic-op-procedure op) x y))
  (values value ((first-partial op) x y value) ((second-partial op) x y value)))

;; The slope by one of two arguments, where the other does not vary.
(define (first-slope op x y value) ((first-partial op) x y value))
(define (second-slope op x y value) ((second-partial op) x y value))

;; An operation that has rules has one for each argument.
(define (first-partial op) (car (rules op)))
(define (second-partial op) (cadr (rules op)))

(define (rules op)
  (define partials (generic-op-partials op))
  (if (pair? partials) partials (raise-no-rule op)))

(define (raise-no-rule op)
  (complain (generic-op-name op) "has no derivative rule"))

;; slope · factor, where most are flonums and many are 1; a factor 1.0 counts as 1 beside
;; a slope that is no number.
(define-syntax-rule (times slope factor)
  (let ([s slope] [f factor])
    (cond [(eq? f 1) s]
          [(eq? s 1) f]
          [(and (flonum? s) (flonum? f)) (fl* s f)]
          [(and (eqv? f 1.0) (not (number? s))) s]
          [else (g:* s f)])))
