#lang racket/base
;; Styles of layers, checked.

(require "axes/axis-label.rkt" "picture-layer.rkt" "on-demand.rkt"
         "../../generic/wrong-argument.rkt")

(provide make-style check-dash)

(define (make-style who kind color size dash label)
  (unless (color? color)
    (complain-of-argument
     who "a color: a name such as 'red, a small integer, or a list of three bytes" color))
  (unless (or (and (real? size) (<= 0 size 1000)) (and (not size) (eq? kind 'points)))
    (complain-of-argument who "a size in pixels, from 0 to 1000" size))
  (check-dash who dash)
  (style kind color size dash (checked-label who "label" label)))

(define (check-dash who dash)
  (define dashes '(solid dot long-dash short-dash dot-dash))
  (unless (memq dash dashes)
    (complain-of-argument who (format "a line style, one of ~a" dashes) dash)))

;; Names of colors are looked up in the drawing library, if it can be loaded.
(define (color? x)
  (cond [(or (symbol? x) (string? x)) (or (not (can-draw?)) (color-name? x))]
        [(list? x) (and (= (length x) 3) (andmap byte? x))]
        [else (and (exact-integer? x) (< (abs x) 1000))]))
