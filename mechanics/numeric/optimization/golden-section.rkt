#lang racket/base
;; A minimum of a function of one variable on an interval, by golden sections.
;;
;; Of two points inside the interval the better one stays, and the part beyond the
;; other goes.  Where they divide it in the golden ratio, a = (3 − √5)/2 from either
;; end, the one that stays divides the rest in the same ratio, so that each step
;; takes one evaluation and leaves 1 − a = 0.618 of the interval.  No function with
;; one minimum is harder than any other.

(require "point.rkt"
         "../constants.rkt" "../checked-arguments.rkt"
         "../../error/failure.rkt")

(provide golden-section width-at-most)

(define most-steps 200)

;; done? : low, best and high point, the values there and the count of steps -> boolean
;; -> (list argument value steps)
(define (golden-section f low high done? [observe void])
  (define who 'golden-section-min)
  (check-interval who low high)
  (define at (observed who f observe))
  (define (between p q part) (at (+ (point-x p) (* part (- (point-x q) (point-x p))))))
  (define a (at (real->double-flonum (min low high))))
  (define b (at (real->double-flonum (max low high))))
  (let loop ([a a] [left (between a b golden-part)] [right (between b a golden-part)] [b b]
             [count 0])
    (define best (if (<= (point-y left) (point-y right)) left right))
    (cond
      [(done? (point-x a) (point-x best) (point-x b) (point-y a) (point-y best) (point-y b) count)
       (list (point-x best) (point-y best) count)]
      [(>= count most-steps)
       (raise-not-convergent who "no minimum found" (point-x best) (- (point-x b) (point-x a))
                             "steps" count)]
      [(eq? best left) (loop a (between a right golden-part) left right (+ count 1))]
      [else (loop left right (between b left golden-part) b (+ count 1))])))

;; The interval is no longer than the tolerance times the size of the argument or, near
;; zero, times a hundredth of its first length.
(define (width-at-most tolerance)
  (define first-width #f)
  (lambda (low x high y-low y y-high count)
    (unless first-width (set! first-width (- high low)))
    (<= (- high low) (* 2.0 (max 1e-15 tolerance) (max (abs x) (* 1e-2 first-width))))))
