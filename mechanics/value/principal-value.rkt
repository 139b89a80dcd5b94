#lang racket/base
;; Angles brought back to one turn (SICM 1.7, p. 76).

(require "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../algebra/expression/operation.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/kind.rkt" "../generic/rounding.rkt"
         "../generic/tracing.rkt" "../generic/up-down.rkt"
         "../numeric/constants.rkt" "../numeric/finite-number.rkt")

(provide principal-value)

;; x ↦ the angle in [cut - 2π, cut) that differs from x by whole turns, for an angle
;; or a tuple of them.  Whole turns are constant in between: the derivative is 1.
(define (principal-value given)
  (define cut (if (symbolic? given) (constant-value given) given))
  (unless (finite? cut)
    (raise-not-an-angle "expected a cut that is a real number" given))
  (define low (- cut :2pi))
  (define (principal x)
    (cond [(real? x) (wrap x low cut :2pi)]
          [(tuple? x) (structure-map principal (adopt x))]
          [(and (being-traced?) (open-leaf? x)) (make-node op:wrapped (list x low cut :2pi))]
          [(and (symbolic? x) (constant-value x)) => principal]
          [(symbolic? x) (raise-not-an-angle "expected an angle that is a real number" x)]
          [(carrier? x)
           (define angle (undisturbed x))
           (g:+ (g:- x angle) (principal angle))]
          [else (g:- x (g:* :2pi (g:floor (g:/ (g:- x low) :2pi))))]))
  (unary-function (lambda () (list 'principal-value given)) (x)
    (principal x)))

;; The angle without the ε of x.  An angle that varies is differentiable also where it is brought
;; back by a turn.
(define (undisturbed x) (if (carrier? x) (undisturbed (comparand x)) x))

(define (raise-not-an-angle what x)
  (complain 'principal-value "~a\n  given: ~a~a" what (describe-with-value x)
            (if (symbolic? x) symbols-hint "")))
