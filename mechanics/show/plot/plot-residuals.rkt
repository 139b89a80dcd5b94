#lang racket/base
;; Residuals of data after a fit of a motion, over the time: points about a line at 0.

(require "draw.rkt" "frame.rkt" "points.rkt" "style.rkt"
         "../../generic/define-plain.rkt" "../../generic/wrong-argument.rkt"
         "../../scale/data/on-demand.rkt"
         (only-in "../../value/structure.rkt" ref structure->list))

(provide plot-residuals)

;; component : of the numbers that were measured, from 0
(define-plain (plot-residuals f fit [component 0]
                              #:color [color 0] #:size [size 4] #:label [label #f])
  (define who 'plot-residuals)
  (check-open who f)
  (check-argument who motion-fit? fit "a fit, as fit-motion gives it")
  (define rows (motion-fit-residuals fit))
  (define count (- (length (structure->list (car rows))) 1))
  (check-argument who (lambda (k) (and (exact-nonnegative-integer? k) (< k count))) component
                  (format "which of ~a measured numbers, from 0" count))
  (define points (make-points))
  (for ([row (in-list rows)]) (add-point! points (ref row 0) (ref row (+ 1 component))))
  (define bounds (frame-bounds f))
  (plot-line f (car bounds) 0 (cadr bounds) 0 #:style 'dot)
  (add-layer! who f (make-style who 'points color size 'solid label) points)
  f)
