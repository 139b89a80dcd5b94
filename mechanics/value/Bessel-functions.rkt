#lang racket/base
;; Bessel functions of real order and argument, and their derivatives.
;;
;; Of negative orders (Abramowitz and Stegun, 9.1.2, 9.6.2, 9.6.6)
;;
;;     J₋ᵥ = cos νπ Jᵥ − sin νπ Yᵥ,    Y₋ᵥ = sin νπ Jᵥ + cos νπ Yᵥ,
;;     I₋ᵥ = Iᵥ + (2/π) sin νπ Kᵥ,     K₋ᵥ = Kᵥ;
;;
;; J and I of whole order are even or odd, of other orders they are real for x ≥ 0 alone, as Y
;; and K are for x > 0.  The derivatives are of the orders next to it (9.1.27, 9.6.26).

(require "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/dispatch.rkt"
         "../generic/kind.rkt" "../generic/wrong-argument.rkt"
         "../numeric/special/Bessel-modified.rkt" "../numeric/special/Bessel-waves.rkt"
         "../numeric/constants.rkt"
         "../numeric/finite-number.rkt")

(provide Bessel-J Bessel-Y Bessel-I Bessel-K spherical-Bessel-j spherical-Bessel-y)

;; ---------------------------------------------------------------------------
;; Of numbers, and of perturbed values

;; numeric : who order flonum -> flonum; slope : the derivative by x, of order n
(define-syntax-rule (define-Bessel name numeric (n x) slope)
  (define (name n x)
    (check-order 'name n)
    (define (value x)
      (cond [(has-kind? x) (dispatch-unary op x)]
            [else
             (check-finite 'name x)
             (check-size 'name n x (numeric 'name n (real->double-flonum x)))]))
    (define op (generic-op 'name #f value (list (lambda (x value) slope)) #f '((0.3 0.9))))
    (value x)))

(define (half combine f n x) (g:* 1/2 (combine (f (- n 1) x) (f (+ n 1) x))))

(define-Bessel Bessel-J J (n x) (half g:- Bessel-J n x))
(define-Bessel Bessel-Y Y (n x) (half g:- Bessel-Y n x))
(define-Bessel Bessel-I I (n x) (half g:+ Bessel-I n x))
(define-Bessel Bessel-K K (n x) (g:- 0 (half g:+ Bessel-K n x)))

(define-Bessel spherical-Bessel-j spherical-j (n x) (spherical-slope spherical-Bessel-j n x))
(define-Bessel spherical-Bessel-y spherical-y (n x) (spherical-slope spherical-Bessel-y n x))

;; n/x f(n) − f(n + 1) as (f(n − 1) n − f(n + 1) (n + 1))/(2n + 1), in which nothing is divided by x
(define (spherical-slope f n x)
  (g:/ (g:- (if (eqv? n 0) 0 (g:* n (f (- n 1) x))) (g:* (+ n 1) (f (+ n 1) x)))
       (+ (* 2 n) 1)))

;; ---------------------------------------------------------------------------
;; Numbers

;; both, combine : as `reflected` has them
(define (J who order x)
  (even-or-odd who order x Bessel-J+Y (lambda (c s J Y) (- (times c J) (times s Y)))))

(define (I who order x)
  (even-or-odd who order x modified (lambda (c s I K) (+ I (times s (* (/ 2.0 pi) K))))))

(define (even-or-odd who order x both combine)
  (cond [(and (= x 0.0) (or (>= order 0) (integer? order))) (if (= order 0) 1.0 0.0)]
        [(< x 0.0)
         (check-whole who order x)
         (* (parity order) (even-or-odd who order (- x) both combine))]
        [else
         (check-positive who x)
         (reflected order x both combine)]))

(define (Y who order x)
  (check-positive who x)
  (reflected order x Bessel-J+Y (lambda (c s J Y) (+ (times s J) (times c Y)))))

(define (K who order x)
  (check-positive who x)
  (define-values (I K) (modified (abs (real->double-flonum order)) x))
  K)

;; Far beyond the range of flonums nothing is computed.
(define (modified order x)
  (if (> x (+ 1500.0 (* 10.0 order)))
      (values +inf.0 0.0)
      (Bessel-I+K order x)))

;; both : |ν| x -> two functions; combine : cos πν, sin πν and these
;; numbers for order −ν; 1, 0 and them for ν
(define (reflected order x both combine)
  (define n (abs (real->double-flonum order)))
  (define-values (one other) (both n x))
  (define-values (c s) (if (< order 0) (direction n) (values 1.0 0.0)))
  (combine c s one other))

;; 0 · ∞ is 0 here: the function that is not asked for may overflow.
(define (times a b) (if (= a 0.0) 0.0 (* a b)))

(define (spherical-j who n x)
  (check-natural who n)
  (if (< (abs x) 1.0) (spherical-j-near-0 n x) (spherical n x (lambda (J Y) J))))

;; xⁿ/(1·3 … (2n + 1)) Σ (−x²/2)ᵏ/(k! (2n + 3) … (2n + 2k + 1)), where J of the order n + 1/2 may be
;; too small for a flonum
(define (spherical-j-near-0 n x)
  (define scale (for/fold ([scale 1.0]) ([k (in-range n)]) (/ (* scale x) (+ k k 3))))
  (let loop ([k 1] [term scale] [sum scale])
    (define next (/ (* term -0.5 x x) (* k (+ n n k k 1))))
    (if (= (+ sum next) sum) sum (loop (+ k 1) next (+ sum next)))))

(define (spherical-y who n x)
  (check-natural who n)
  (when (= x 0.0) (check-positive who x))
  (* (if (< x 0.0) -1.0 1.0) (spherical n x (lambda (J Y) Y))))

(define (spherical n x choose)
  (define f (call-with-values (lambda () (Bessel-J+Y (+ n 0.5) (abs x))) choose))
  (* (if (< x 0.0) (parity n) 1.0) (/ (sqrt (/ pi 2.0)) (sqrt (abs x))) f))

(define (parity n) (if (even? (inexact->exact n)) 1.0 -1.0))

;; cos πν and sin πν, exactly where ν is whole or half of a whole number
(define (direction n)
  (define r (- n (* 2.0 (floor (/ n 2.0)))))
  (cond [(= r 0.0) (values 1.0 0.0)]
        [(= r 0.5) (values 0.0 1.0)]
        [(= r 1.0) (values -1.0 0.0)]
        [(= r 1.5) (values 0.0 -1.0)]
        [else (values (cos (* pi r)) (sin (* pi r)))]))

;; ---------------------------------------------------------------------------
;; Complaints

(define most-order 1e5)

(define (check-order who order)
  (when (has-kind? order)
    (complain who "has no derivative by its order; given ~a" (describe-with-value order)))
  (unless (and (real? order) (< (abs order) most-order))
    (complain who "expected a real number below ~a in size as order; given ~a"
              100000 (describe-with-value order))))

(define (check-finite who x)
  (unless (and (real? x) (finite? (real->double-flonum x)))
    (complain-of-argument who "a finite real number" x)))

(define (check-natural who n)
  (check-argument who exact-nonnegative-integer? n "a natural number as order"))

(define (check-positive who x)
  (unless (> x 0.0)
    (complain who "expected a positive number, for it is infinite or not real at others; given ~a"
              x)))

(define (check-whole who order x)
  (unless (integer? order)
    (complain who
              "of a negative number it is real for whole orders alone; given the order ~a and ~a"
              order x)))

(define (check-size who order x y)
  (unless (finite? y)
    (complain who "the value at ~a, of order ~a, is too great for a floating-point number" x order))
  y)
