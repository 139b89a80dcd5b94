#lang racket/base
;; Functions of numbers that mathematical physics has names for.
;;
;; They are functions of numbers and not of expressions: no derivatives are taken of them.

(require (only-in math/special-functions [gamma math:gamma])
         (only-in racket/math nan?)
         "series/coefficients.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt"
         "../numeric/Bessel.rkt")

(provide gamma (rename-out [factorial-of factorial])
         bessj bessj0 bessj1)

(define (gamma x)
  (check-real 'gamma x)
  (when (and (rational? x) (integer? x) (<= x 0))
    (complain 'gamma "there is a pole at 0, -1, -2, ...; given the number ~a" x))
  (math:gamma x))

(define (factorial-of n)
  (unless (exact-nonnegative-integer? n)
    (complain 'factorial "expected a natural number; given ~a~a" (describe-with-value n)
              (if (real? n) "; of other numbers x it is (gamma (+ x 1))" "")))
  (factorial n))

;; J of order n at x; of −n or at −x it is (−1)ⁿ times that.
(define (bessj n x)
  (unless (exact-integer? n)
    (complain 'bessj "expected a whole order; given ~a" (describe-with-value n)))
  (check-real 'bessj x)
  (unless (< (abs x) most)
    (complain 'bessj "expected a number below ~a in size; given ~a" most x))
  (define value (Bessel-J (abs n) (abs (real->double-flonum x))))
  (define turns (+ (if (negative? n) 1 0) (if (negative? x) 1 0)))
  (if (and (odd? n) (odd? turns)) (- value) value))

(define most 1e6)

(define (bessj0 x) (bessj 0 x))
(define (bessj1 x) (bessj 1 x))

(define (check-real who x)
  (unless (and (real? x) (not (nan? (real->double-flonum x))))
    (complain who "expected a real number; given ~a" (describe-with-value x))))
