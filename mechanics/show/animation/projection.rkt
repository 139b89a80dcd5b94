#lang racket/base
;; Space seen from a little above, z up: a parallel projection, so that lengths along one
;; direction stay in proportion wherever they are.

(require "plane-vector.rkt" "shapes.rkt"
         "../../numeric/constants.rkt")

(provide in-view on-vertical nearness space-ring level-ring space-axes)

;; Where the eye is: its azimuth, from the x axis, and its height, as angles.
(define azimuth (* -0.30 pi))
(define height (* 0.11 pi))

(define-values (ca sa ch sh) (values (cos azimuth) (sin azimuth) (cos height) (sin height)))

;; Points and vectors of space are lists of three numbers.

;; The point of the picture where a point of space is seen.
(define (in-view p)
  (define-values (x y z) (apply values p))
  (vector (- (* ca y) (* sa x))
          (- (* ch z) (* sh (+ (* ca x) (* sa y))))))

;; The point at this height above the origin, as it is seen.
(define (on-vertical z) (in-view (list 0.0 0.0 z)))

;; How far towards the eye a point of space is.
(define (nearness p)
  (define-values (x y z) (apply values p))
  (+ (* ch (+ (* ca x) (* sa y))) (* sh z)))

;; Points of the circle about a center that passes through center + u and center + v.
(define (space-ring center u v)
  (for/list ([k (in-range 49)])
    (define angle (/ (* 2.0 pi k) 48))
    (in-view (map + center (scaled (cos angle) u) (scaled (sin angle) v)))))

;; A horizontal circle about the vertical through the origin.
(define (level-ring z radius)
  (space-ring (list 0.0 0.0 z) (list radius 0.0 0.0) (list 0.0 radius 0.0)))

(define (space-axes long)
  (define center (on-vertical 0.0))
  (for/list ([name (in-list '("x" "y" "z"))]
             [axis (in-list '((1.0 0.0 0.0) (0.0 1.0 0.0) (0.0 0.0 1.0)))])
    (define end (in-view (scaled long axis)))
    (list (polyline (list center end) #:width 1 #:color faint #:arrows 'end)
          (label end name #:color faint #:size 13 #:shift (times 10.0 (unit (minus end center)))))))

(define (unit v) (times (/ 1.0 (span v)) v))
