#lang racket/base
;; The part of the plane that shapes take up.

(require "plane.rkt" "shapes.rkt")

(provide extent fitting-scale)

(define margin 6.0)              ; pixels

;; scale : pixels to a unit -> (list x-min x-max y-min y-max), with a margin
(define (extent shapes scale)
  (define corners (apply append (map (lambda (s) (corners-of s scale)) shapes)))
  (define (bound choose part change) (change (apply choose (map part corners)) (/ margin scale)))
  (list (bound min at-x -) (bound max at-x +) (bound min at-y -) (bound max at-y +)))

;; Pixels to a unit, so that all but letters is at most so many pixels high, and 1.7 times as
;; wide.
(define (fitting-scale shapes size)
  (define bounds (extent (filter (lambda (s) (not (lettering? s))) shapes) +inf.0))
  (/ size (max 1e-9 (/ (- (cadr bounds) (car bounds)) 1.7) (- (cadddr bounds) (caddr bounds)))))

(define (corners-of s scale)
  (cond [(stroke? s) (stroke-points s)]
        [(spot? s) (box (spot-center s) (vector 0.0 0.0) (spot-radius s) (spot-radius s))]
        [else (lettering-corners s scale)]))

(define (box p shift wide high)
  (list (add (add p shift) (vector wide high)) (minus (add p shift) (vector wide high))))

;; The letters' width is estimated.
(define (lettering-corners s scale)
  (define size (/ (lettering-size s) scale))
  (define wide (* 0.31 size (+ 1 (string-length (lettering-text s)))))
  (define-values (x y)
    (case (lettering-anchor s)
      [(left) (values (- wide) 0.0)]
      [(right) (values wide 0.0)]
      [(above) (values 0.0 size)]
      [(below) (values 0.0 (- size))]
      [else (values 0.0 0.0)]))
  (define shift (times (/ 1.0 scale) (lettering-shift s)))
  (box (lettering-at s) (add (vector x y) shift) wide (* 0.7 size)))
