#lang racket/base
;; What follows an orbit of a map and shows its points: a *collector* (SICM 6.7, p. 456).
;;
;; It is called like a map, with two coordinates, and with what is to be called with the last ones
;; and what where there is no image.  explore-map takes one in place of a map where it is given #f
;; for the number of points.  The coordinates may be anything that the map takes: states, where
;; the map has to keep more of a motion than is shown of it.

(require "draw.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/wrong-argument.rkt"
         "../../dynamics/map/map-of-the-plane.rkt")

(provide default-collector default-monitor)

;; monitor : x y -> any; shows a point
(define ((default-collector monitor map n) x y done fail)
  (unless (and (procedure? monitor) (accepts? monitor 2))
    (complain 'default-collector "what shows points is a procedure of two coordinates; given ~a"
              (describe-with-value monitor)))
  (check-map 'default-collector map)
  (check-argument 'default-collector exact-nonnegative-integer? n
                  "how many images are followed, a natural number")
  (let follow ([n n] [x x] [y y])
    (monitor x y)
    (if (= n 0)
        (done x y)
        (map x y (lambda (x y) (follow (- n 1) x y)) fail))))

(define ((default-monitor f) x y) (plot-point f x y))
