#lang racket/base
;; Functions of numbers that mathematical physics has names for.
;;
;; They are functions of numbers and not of expressions.  Derivatives are taken of those that
;; have them in functions of this page: Γ' = Γ ψ, erfc' x = −2 e^(−x²)/√π, W' = e^(−W)/(1 + W)
;; (Abramowitz and Stegun, 6.3, 7.1).

(require (prefix-in math: (only-in math/special-functions
                                   gamma log-gamma psi beta erfc zeta lambert))
         (only-in racket/math nan?)
         "Bessel-functions.rkt" "series/coefficients.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/dispatch.rkt"
         "../generic/elementary.rkt" "../generic/kind.rkt" "../generic/wrong-argument.rkt")

(provide gamma (rename-out [factorial-of factorial])
         log-gamma beta erfc zeta Lambert-W
         bessj bessj0 bessj1)

;; ---------------------------------------------------------------------------
;; Of numbers, and of perturbed values

;; A function of a number, of which (slope x value) is the derivative.
(define (lifted name numeric slope)
  (define (value x)
    (cond [(has-kind? x) (dispatch-unary op x)]
          [else (check-real name x) (numeric x)]))
  (define op (generic-op name #f value (list slope) #f '((0.3 0.9))))
  value)

(define (check-not-pole who x)
  (when (and (rational? x) (integer? x) (<= x 0))
    (complain who "there is a pole at 0, -1, -2, ...; given the number ~a" x)))

;; The m-th derivative of log Γ, m > 0
(define (polygamma m)
  (lifted 'polygamma
          (lambda (x) (math:psi (- m 1) (real->double-flonum x)))
          (lambda (x value) ((polygamma (+ m 1)) x))))

(define gamma
  (lifted 'gamma
          (lambda (x) (check-not-pole 'gamma x) (math:gamma x))
          (lambda (x value) (g:* value ((polygamma 1) x)))))

(define log-gamma
  (lifted 'log-gamma
          (lambda (x) (check-not-pole 'log-gamma x) (math:log-gamma (real->double-flonum x)))
          (lambda (x value) ((polygamma 1) x))))

;; B(x, y) = Γ(x) Γ(y)/Γ(x + y)
(define (beta x y)
  (cond [(or (has-kind? x) (has-kind? y))
         (g:exp (g:- (g:+ (log-gamma x) (log-gamma y)) (log-gamma (g:+ x y))))]
        [else
         (for ([z (list x y)])
           (check-real 'beta z)
           (unless (> z 0) (complain 'beta "expected positive numbers; given ~a" z)))
         (math:beta (real->double-flonum x) (real->double-flonum y))]))

(define erfc
  (lifted 'erfc
          (lambda (x) (math:erfc (real->double-flonum x)))
          (lambda (x value) (g:negate ((car (generic-op-partials (elementary-operation 'erf 1)))
                                       x value)))))

;; The branch W ≥ −1 of w e^w = x
(define Lambert-W
  (lifted 'Lambert-W
          (lambda (x)
            (unless (>= x (- (exp -1.0)))
              (complain 'Lambert-W "expected a number from -1/e on; given ~a" x))
            (math:lambert (real->double-flonum x)))
          (lambda (x value) (g:/ (g:exp (g:- 0 value)) (g:+ 1 value)))))

;; No derivative: racket/math has none of it.
(define (zeta x)
  (when (has-kind? x) (complain 'zeta "has no derivative here"))
  (check-real 'zeta x)
  (when (= x 1) (complain 'zeta "there is a pole at 1"))
  (math:zeta (real->double-flonum x)))

(define (factorial-of n)
  (unless (exact-nonnegative-integer? n)
    (complain-of-argument 'factorial "a natural number" n
                          (if (real? n) "\n  of other numbers x it is (gamma (+ x 1))" "")))
  (factorial n))

(define (bessj n x)
  (check-argument 'bessj exact-integer? n "a whole order")
  (unless (has-kind? x)
    (check-real 'bessj x)
    (unless (< (abs x) most)
      (complain 'bessj "expected a number below ~a in size; given ~a" most x)))
  (Bessel-J n x))

(define most 1e6)

(define (bessj0 x) (bessj 0 x))
(define (bessj1 x) (bessj 1 x))

(define (check-real who x)
  (unless (and (real? x) (not (nan? (real->double-flonum x))))
    (complain-of-argument who "a real number" x)))
