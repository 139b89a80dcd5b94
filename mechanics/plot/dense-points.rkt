#lang racket/base
;; Very many points as one image over a plot, instead of a glyph for each.

(require (only-in pict bitmap pin-over scale)
         plot/no-gui
         (only-in plot/utils ->pen-color)
         (only-in racket/class send)
         (only-in racket/draw make-bitmap the-color-database)
         "layer.rkt" "pixels.rkt" "points.rkt")

(provide with-dense-points)

;; Of the image in each pixel of the plot, so that it looks well on paper, too.
(define fineness 2)

;; p : a plot as a pict; layers : of points
(define (with-dense-points p bounds layers)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define place (plot-pict-plot->dc p))
  (define corner (place (vector x-min y-max)))
  (define opposite (place (vector x-max y-min)))
  (define (pixels-along k)
    (max 1 (inexact->exact (round (* fineness (- (vector-ref opposite k) (vector-ref corner k)))))))
  (define image (make-pixels bounds (pixels-along 0) (pixels-along 1)))
  (for ([l (in-list layers)])
    (define s (layer-data l))
    (mark! image (snapshot-xs s) (snapshot-ys s) 0 (snapshot-count s)
           (color->bytes (style-color (layer-style l)))))
  (pin-over p (vector-ref corner 0) (vector-ref corner 1)
            (scale (bitmap (pixels->bitmap image)) (/ 1.0 fineness))))

(define (pixels->bitmap p)
  (define b (make-bitmap (pixels-width p) (pixels-height p)))
  (send b set-argb-pixels 0 0 (pixels-width p) (pixels-height p) (pixels-bytes p))
  b)

;; A number, a name or three bytes, as plot has colours.
(define (color->bytes c)
  (define named (and (or (symbol? c) (string? c))
                     (send the-color-database find-color (if (symbol? c) (symbol->string c) c))))
  (if named
      (list (send named red) (send named green) (send named blue))
      (->pen-color c)))
