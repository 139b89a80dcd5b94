#lang racket/base
;; Space seen from a little above, z up: a parallel projection, so that lengths along one
;; direction stay in proportion wherever they are.

(require "plane.rkt" "shapes.rkt"
         "../../numeric/constants.rkt")

(provide in-view nearness space-ring space-axes)

;; Where the eye is: its azimuth, from the x axis, and its height, as angles.
(define azimuth (* -0.30 pi))
(define height (* 0.11 pi))

(define-values (ca sa ch sh) (values (cos azimuth) (sin azimuth) (cos height) (sin height)))

;; A point of space -> of the picture
(define (in-view x y z)
  (vector (- (* ca y) (* sa x))
          (- (* ch z) (* sh (+ (* ca x) (* sa y))))))

;; How far towards the eye it is.
(define (nearness x y z) (+ (* ch (+ (* ca x) (* sa y))) (* sh z)))

;; Points of a circle about (x, y, z) through the two vectors u and v, lists of three.
(define (space-ring center u v)
  (define (component k c s)
    (+ (list-ref center k) (* c (list-ref u k)) (* s (list-ref v k))))
  (for/list ([k (in-range 49)])
    (define angle (/ (* 2.0 pi k) 48))
    (define-values (c s) (values (cos angle) (sin angle)))
    (in-view (component 0 c s) (component 1 c s) (component 2 c s))))

(define (space-axes long)
  (define origin (in-view 0.0 0.0 0.0))
  (for/list ([name (in-list '("x" "y" "z"))]
             [x '(1.0 0.0 0.0)] [y '(0.0 1.0 0.0)] [z '(0.0 0.0 1.0)])
    (define end (in-view (* long x) (* long y) (* long z)))
    (list (polyline (list origin end) #:width 1 #:color faint #:arrows 'end)
          (label end name #:color faint #:size 13 #:shift (times 10.0 (unit (minus end origin)))))))

(define (unit v) (times (/ 1.0 (span v)) v))
