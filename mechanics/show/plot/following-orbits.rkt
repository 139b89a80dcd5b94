#lang racket/base
;; A *collector* follows an orbit of a map and shows its points (SICM 6.7, p. 456).
;;
;; It is called like a map, with two coordinates and two procedures: the first receives the last
;; coordinates, the second is called where there is no image.  explore-map takes a collector in
;; place of a map if the number of points is #f.  The coordinates may be any values that the map
;; takes, such as states, if the map has to keep more of a motion than it shows.

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
