#lang racket/base
;; Vectors of the plane, as Racket vectors of two flonums, for calculations of drawings.
;;
;; x goes to the right and y up.  Angles of mechanisms are measured from the vertical that
;; hangs down, as a pendulum's is; those of `turned` from the x axis, as in mathematics.

(require racket/math)

(provide origin at-x at-y add minus times below turned direction crosswise span between arc scaled)

(define origin (vector 0.0 0.0))

(define (at-x p) (vector-ref p 0))
(define (at-y p) (vector-ref p 1))

(define (add p q) (vector (+ (at-x p) (at-x q)) (+ (at-y p) (at-y q))))
(define (minus p q) (vector (- (at-x p) (at-x q)) (- (at-y p) (at-y q))))
(define (times a p) (vector (* a (at-x p)) (* a (at-y p))))

;; From p in the direction that hangs down, turned by the angle counterclockwise.
(define (below p length angle)
  (add p (vector (* length (sin angle)) (* -1.0 length (cos angle)))))

;; Of this length, at this angle from the x axis.
(define (turned length angle) (vector (* length (cos angle)) (* length (sin angle))))

;; The angle of a vector from the x axis.
(define (direction p) (atan (at-y p) (at-x p)))

;; Turned to the left by a right angle.
(define (crosswise p) (vector (- (at-y p)) (at-x p)))

(define (span p) (sqrt (+ (* (at-x p) (at-x p)) (* (at-y p) (at-y p)))))

;; The point that divides the way from p to q: 0 at p, 1 at q.
(define (between p q share) (add (times (- 1.0 share) p) (times share q)))

;; Points of an arc about a centre, close enough to look round.
(define (arc center radius from to)
  (define pieces (max 2 (exact-ceiling (* 32 (/ (abs (- to from)) pi)))))
  (for/list ([k (in-range (+ pieces 1))])
    (add center (turned radius (+ from (* (- to from) (/ k pieces)))))))

;; A list of numbers, each times a.
(define (scaled a xs) (for/list ([x (in-list xs)]) (* a x)))
