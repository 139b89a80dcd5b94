#lang racket/base
;; Definite integrals to infinity, and of functions that are infinite at some points.
;;
;; An infinite range, but for a beginning of about the length of its distance from
;; zero, becomes [0, 1] by x = b + u (1 − t)/t, dx = −u dt/t².
;;
;; A function that is infinite at an end is integrated towards it (singular-end.rkt).
;; Where the function is infinite between the ends, halving finds the point to within
;; rounding; there the interval is divided.

(require "gauss-kronrod.rkt" "oscillating.rkt" "singular-end.rkt"
         "../sample.rkt"
         "../../error/failure.rkt")

(provide improper-quadrature)     ; (improper-quadrature f low high) -> flonum, error bound

;; The tolerance is relative to ∫ |f|, over each half of an infinite range.
(define (improper-quadrature f low high
                             #:tolerance [tolerance 1e-10]
                             #:name [who 'quadrature])
  (check-limit who low)
  (check-limit who high)
  (check-tolerance who tolerance)
  (define a (real->double-flonum low))
  (define b (real->double-flonum high))
  (define (to-infinity from direction) (half-line f from direction tolerance who))
  (cond [(= a b) (values 0.0 0.0)]
        [(> a b)
         (define-values (value bound)
           (improper-quadrature f b a #:tolerance tolerance #:name who))
         (values (- value) bound)]
        [(and (= a -inf.0) (= b +inf.0))
         (both (lambda () (to-infinity 0.0 -1.0)) (lambda () (to-infinity 0.0 1.0)))]
        [(= b +inf.0) (to-infinity a 1.0)]
        [(= a -inf.0) (to-infinity b -1.0)]
        [else (over-interval f a b tolerance who values)]))

;; direction : 1.0 or -1.0, by which the integral is not affected
(define (half-line f from direction tolerance who)
  (define unit (max 1.0 (abs from)))
  (define near (+ from (* direction unit)))
  (define (x t) (+ near (* direction unit (/ (- 1.0 t) t))))
  (define (h t) (/ (* unit (sample who f (x t))) (* t t)))
  (define (along s) (sample who f (+ near (* direction s))))
  (define (beginning) (over-interval f (min from near) (max from near) tolerance who values))
  (define (far)
    (let/ec return
      (call-or-fail (lambda () (over-interval h 0.0 1.0 tolerance who x 0)) return)
      (call-or-fail (lambda () (oscillating-quadrature along unit tolerance)) return)
      (over-interval h 0.0 1.0 tolerance who x)))
  (both beginning far))

;; Two integrals and their bounds added.
(define (both one other)
  (define-values (value bound) (one))
  (define-values (value* bound*) (other))
  (values (+ value value*) (+ bound bound*)))

(define (check-limit who x)
  (unless (and (real? x) (= x x))
    (raise-argument-error who "a real number, perhaps infinite, as limit of integration" x)))

(define most-panels-at-edge 200)
(define most-divisions 6)          ; of an interval, of its parts, of theirs ...

;; By halving panels; where they get narrow at an end, towards both ends; and if that
;; fails, or they get narrow inside, in two parts.  What helps nowhere fails as halving does.
;; place : what the user knows a point as
(define (over-interval f a b tolerance who place [divisions most-divisions])
  (define (plain edge divide)
    (quadrature/error f a b #:tolerance tolerance #:place place #:edge edge #:name who
                      #:stuck (lambda (value bound x) (when x (divide x)))))
  (define (divided-at c return)
    (when (and (< a c b) (> divisions 0))
      (define (part a b) (over-interval f a b tolerance who place (- divisions 1)))
      (call-or-fail (lambda () (both (lambda () (part a c)) (lambda () (part c b)))) return)))
  (define (from-ends return)
    (define middle (+ a (* 0.5 (- b a))))
    (define-values (left left-bound) (integral-towards f middle a tolerance))
    (define-values (right right-bound)
      (if left (integral-towards f middle b tolerance) (values #f #f)))
    (when right (return (- right left) (+ left-bound right-bound)))
    (divided-at middle return)
    (quadrature/error f a b #:tolerance tolerance #:limit most-panels-at-edge
                      #:place place #:name who))
  (let/ec return
    (define (divide x) (divided-at (worst-near f x) return))
    (define (divide-at-singularity failure)
      (define c (exn:fail:mechanics:singular-where failure))
      (when (and (eq? place values) (real? c)) (divided-at c return))
      (raise failure))
    (with-handlers* ([exn:fail:mechanics:singular? divide-at-singularity])
      (let/ec at-edge
        (call-with-values (lambda () (plain (lambda () (at-edge)) divide)) return))
      (from-ends return))))

;; The values of (f), received by `return`, which may not be called.
(define (call-or-fail f return)
  (define-values (value bound)
    (with-handlers ([exn:fail:mechanics? (lambda (e) (values #f #f))])
      (f)))
  (when value (return value bound)))

;; Of the numbers within rounding of x, the one where |f| is greatest.
(define (worst-near f x)
  (define unit (* 1e-16 (abs x)))
  (define (size y)
    (define z (abs (f y)))
    (if (< z +inf.0) z +inf.0))
  (for/fold ([best x] [most (size x)] #:result best) ([k (in-range -100 101)])
    (define y (+ x (* k unit)))
    (define here (size y))
    (if (> here most) (values y here) (values best most))))
