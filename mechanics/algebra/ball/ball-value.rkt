#lang racket/base
;; Operations on values that are exact rationals or balls.
;;
;; Exact values stay exact, as long as they are short; a function has one at a single
;; point, as log at 1, if at all.

(require "ball.rkt" "ball-elementary.rkt" "ball-functions.rkt" "fixed-point.rkt"
         "../assumption/signs.rkt"
         "../expression/exact-numbers.rkt"
         (only-in "../expression/numeric-functions.rkt" sgn)
         "../expression/operation.rkt"
         "../../operation/operation-column.rkt")

(provide number->value pi->value apply-operation
         value-not-zero? value-signs values-overlap?)

;; Exact numbers of more bits become balls.
(define most-exact-bits 512)

(define (number->value x p)
  (cond [(and (real? x) (exact? x)) (shortened x p)]
        [(rational? x) (flonum->ball x p)]
        [else (raise no-value)]))

;; k π
(define (pi->value k p)
  (define w (+ p 8))
  (times k (make-ball (pi-fixed w) constant-error (- w) p) p))

(define (shortened x p)
  (if (or (fixnum? x) (<= (rational-bits x) most-exact-bits))
      x
      (exact->ball x p)))

(define (value->ball x p) (if (ball? x) x (exact->ball x p)))

;; ---------------------------------------------------------------------------
;; Signs and overlap

;; The signs that it may have.
(define (value-signs v)
  (cond [(not (ball? v)) (number-signs v)]
        [(ball-positive? v) positive]
        [(ball-negative? v) negative]
        [else
         (bitwise-ior zero
                      (if (> (ball-upper v) 0) positive 0)
                      (if (< (ball-lower v) 0) negative 0))]))

(define (value-not-zero? v) (not (signs-within? zero (value-signs v))))

;; May both be the same?  Values of tuples are lists of their names and components.
(define (values-overlap? a b)
  (cond [(and (pair? a) (pair? b))
         (and (eq? (car a) (car b))
              (eqv? (length a) (length b))
              (andmap values-overlap? (cdr a) (cdr b)))]
        [(or (ball? a) (ball? b)) (and (real-value? a) (real-value? b) (balls-overlap? a b))]
        [else (equal? a b)]))

(define (real-value? v) (or (ball? v) (and (rational? v) (exact? v))))

(define (balls-overlap? a b)
  (define p 4096)
  (not (value-not-zero? (ball- (value->ball a p) (value->ball b p) p))))

;; ---------------------------------------------------------------------------
;; Operations

;; met : operation -> table of its values at exact numbers, which large graphs often ask for
(define (apply-operation op arguments p met)
  (cond [(eq? op op:*) (fold times arguments p)]
        [(eq? op op:+) (fold plus arguments p)]
        [(eq? op op:-) (minus (car arguments) (cadr arguments) p)]
        [(eq? op op:/) (over (car arguments) (cadr arguments) p)]
        [(eq? op op:expt) (power (car arguments) (cadr arguments) p)]
        [(hash-ref functions (operation-key (operation-name op) (length arguments)) #f)
         => (lambda (f)
              (define x (car arguments))
              (if (or (ball? x) (pair? (cdr arguments)))
                  (f arguments p)
                  (hash-ref! (hash-ref! met op make-hash) x (lambda () (f arguments p)))))]
        [(memq op (list op:up op:down)) (cons (operation-name op) arguments)]
        [else (raise unknown)]))

(define (fold f arguments p)
  (for/fold ([v (car arguments)]) ([a (in-list (cdr arguments))]) (f v a p)))

(define-syntax-rule (define-arithmetic (name a b p) exact-case exact on-balls)
  (define (name a b p)
    (cond exact-case
          [(or (ball? a) (ball? b)) (on-balls (value->ball a p) (value->ball b p) p)]
          [else (shortened (exact a b) p)])))

(define-arithmetic (plus a b p)
  [(eqv? a 0) b] + ball+)
(define-arithmetic (minus a b p)
  [(eqv? b 0) a] - ball-)
(define-arithmetic (times a b p)
  [(or (eqv? a 0) (eqv? b 0)) 0] * ball*)
(define-arithmetic (over a b p)
  [(eqv? b 0) (raise no-value)] / ball/)

;; f : ball p -> ball; point : an exact number where f has an exact value
;; -> (arguments p -> value)
(define ((function f point value) arguments p)
  (define x (car arguments))
  (if (eqv? x point) value (f (value->ball x p) p)))

(define-column functions
  [sqrt (lambda (arguments p) (root (car arguments) p))]
  [exp (function ball-exp 0 1)]
  [log (function ball-log 1 0)]
  [sin (function ball-sin 0 0)]
  [cos (function ball-cos 0 1)]
  [tan (function ball-tan 0 0)]
  [asin (function ball-asin 0 0)]
  [acos (function ball-acos 1 0)]
  [atan (function ball-atan 0 0)]
  [atan2 (lambda (arguments p) (angle (car arguments) (cadr arguments) p))]
  [sinh (function ball-sinh 0 0)]
  [cosh (function ball-cosh 0 1)]
  [tanh (function ball-tanh 0 0)]
  [asinh (function ball-asinh 0 0)]
  [acosh (function ball-acosh 1 0)]
  [atanh (function ball-atanh 0 0)]
  [erf (function ball-erf 0 0)]
  [abs (lambda (arguments p)
         (define x (car arguments))
         (if (ball? x) (ball-abs x) (abs x)))]
  [sgn (lambda (arguments p) (sign-of (car arguments)))])

(define (angle y x p)
  (cond [(and (eqv? y 0) (eqv? x 0)) (raise no-value)]
        [(and (eqv? y 0) (not (ball? x)) (> x 0)) 0]
        [else (ball-angle (value->ball y p) (value->ball x p) p)]))

(define (sign-of x)
  (cond [(not (ball? x)) (sgn x)]
        [(ball-positive? x) 1]
        [(ball-negative? x) -1]
        [else (raise unknown)]))

(define (root x p)
  (cond [(ball? x) (ball-sqrt x p)]
        [(< x 0) (raise no-value)]
        [else
         (define r (sqrt x))
         (if (exact? r) r (ball-sqrt (exact->ball x (+ p 4)) p))]))

;; ---------------------------------------------------------------------------
;; Powers, real ones

(define (power x n p)
  (cond [(eqv? n 0) 1]
        [(exact-integer? n) (integer-power x n p)]
        [(ball? x) (power-of-ball x n p)]
        [(< x 0) (raise (if (ball? n) unknown no-value))]
        [(eqv? x 0) (if (eqv? 1 (sign-of n)) 0 (raise no-value))]
        [(eqv? x 1) 1]
        [else (power-of-ball x n p)]))

(define (integer-power x n p)
  (cond [(ball? x) (ball-integer-power x n p)]
        [(eqv? x 0) (if (> n 0) 0 (raise no-value))]
        [(or (memv x '(1 -1)) (<= (* (abs n) (rational-bits x)) most-exact-bits)) (expt x n)]
        [else (ball-integer-power (exact->ball x (+ p 32)) n (+ p 32))]))

;; x^(k/2) has a simpler way.
(define (power-of-ball x n p)
  (if (and (not (ball? n)) (eqv? 2 (denominator n)))
      (integer-power (root x (+ p 8)) (numerator n) p)
      (let ([b (value->ball x (+ p 32))])
        (unless (or (ball-positive? b) (not (ball? n))) (raise unknown))
        (ball-power b (value->ball n (+ p 32)) p))))
