#lang racket/base
;; The drawing library, loaded when the first picture is made.

(require "../display/drawing-library.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["picture.rkt" loaded? color-name? draw-picture picture-point]
         ["picture-page.rkt" draw-to-bytes draw-figure]
         ["frame-pict.rkt" make-picture converted-picture])

(provide can-draw? why-not color-name?
         draw-picture make-picture picture-bytes draw-figure picture-point)

;; -> string, which ends with the remedy, or #f
(define why-not (reason-not-to-load loaded?))

(define (can-draw?) (not (why-not)))

;; format : as `convert` names it, 'png-bytes and so on
(define (picture-bytes v layers format default)
  (or (draw-to-bytes v layers format) (converted-picture v layers format default)))
