#lang racket/base
;; The value of an expression at a point, and its error.
;;
;; Values are real, exact or certified by balls (ball/ball-tape.rkt).  Only expressions in which a
;; complex number stands, as in e^(it), have complex values, with bounds to first order on their
;; rounding (approximate.rkt).

(require "approximate.rkt" "../ball/ball.rkt" "../ball/ball-value.rkt"
         "../expression/exact-numbers.rkt" "../expression/flat-graph.rkt")

(provide contains-complex? complex-value
         not-zero? agree? value-bound value-shown value-precise?)

(define (contains-complex? t)
  (for/or ([e (in-vector (tape-items t))]) (and (number? e) (not (real? e)))))

;; A complex number within `error`.
(struct rough (number error) #:authentic)

;; As tape-value, in complex numbers: t : tape, lookup : of its leaves, p : not used.
(define (complex-value t lookup p)
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) no-value)]
                  [symbol? values])
    (define-values (x error) (approximate-tape t lookup))
    (if (and (rational? (magnitude x)) (rational? error)) (rough x error) no-value)))

;; ---------------------------------------------------------------------------

(define (not-zero? v)
  (if (rough? v)
      (> (magnitude (rough-number v)) (* 4 (rough-error v)))
      (value-not-zero? v)))

;; May a and b be one number?
(define (agree? a b)
  (if (rough? a)
      (<= (magnitude (- (rough-number a) (rough-number b)))
          (* 4 (+ (rough-error a) (rough-error b))))
      (values-overlap? a b)))

;; How far it may be from 0.
(define (value-bound v)
  (cond [(rough? v) (rough-error v)]
        [(ball? v) (ball->flonum (ball-upper (ball-abs v)) (ball-scale v))]
        [else 0]))

(define (ball->flonum m e)
  (if (< -2000 e 2000) (exact->inexact (* m (expt 2 e))) (if (> e 0) +inf.0 0.0)))

;; The number to be shown: exact where it is, or where it is beyond flonums; else a flonum with no
;; more digits than are certain.
(define (value-shown v)
  (cond [(rough? v) (rough-number v)]
        [(ball? v) (certain-digits v)]
        [else v]))

(define (certain-digits b)
  (define x (ball->flonum (ball-middle b) (ball-scale b)))
  (cond [(and (memv x '(0.0 +inf.0 -inf.0)) (< (abs (ball-scale b)) most-scale))
         (* (ball-middle b) (expt 2 (ball-scale b)))]
        [(>= (certain-bits b) flonum-bits) x]
        [else (to-digits x (max 1 (inexact->exact (floor (* (certain-bits b) bit-digits)))))]))

(define most-scale 20000)

(define flonum-bits 54)
(define bit-digits (/ (log 2) (log 10)))

;; So many bits of the middle are beyond doubt.
(define (certain-bits b)
  (- (integer-length (ball-middle b)) (integer-length (ball-radius b)) 1))

;; Are as many digits certain as a verdict shows?
(define (value-precise? v) (or (not (ball? v)) (>= (certain-bits v) 24)))
