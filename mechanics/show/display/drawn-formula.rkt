#lang racket/base
;; Snips that draw a formula, in the color and size of the letters of their style.

(require "../../generic/on-demand.rkt"
         racket/class racket/snip)

(require-on-demand ["formula-drawing.rkt" make-drawing drawing-width drawing-height
                                          drawing-descent draw-drawing])

(provide drawn-formula%)

(define drawn-formula%
  (class snip%
    (init-field formula)
    (inherit get-style)
    (super-new)

    (define drawing #f)               ; as it was drawn last
    (define drawn-size #f)

    (define/private (present-drawing)
      (define size (send (send (get-style) get-font) get-size))
      (unless (equal? size drawn-size)
        (set! drawing (make-drawing formula size))
        (set! drawn-size size))
      drawing)

    (define/override (get-extent dc x y . boxes)
      (give-extent (present-drawing) boxes))
    (define/override (draw dc x y left top right bottom dx dy caret)
      (draw-drawing (present-drawing) dc x y (send (get-style) get-foreground)))

    ;; A tall one is scrolled through.
    (define/override (get-num-scroll-steps)
      (max 1 (steps (drawing-height (present-drawing)))))
    (define/override (find-scroll-step y) (max 0 (steps y)))
    (define/override (get-scroll-step-offset n) (* n step))))

(define step 16)
(define (steps y) (quotient (inexact->exact (ceiling y)) step))

;; boxes : up to six, for width, height, descent and the spaces above, left and right; #f for one
;; that is not wanted
(define (give-extent d boxes)
  (define extent (list (drawing-width d) (drawing-height d) (drawing-descent d) 0 0 0))
  (for ([b (in-list boxes)] [value (in-list extent)])
    (when b (set-box! b value))))
