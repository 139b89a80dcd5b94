#lang racket/base
;; Images in a plot: very many points as one above it, instead of a glyph for each; and colours
;; of parts of the plane beneath it.

(require (only-in pict bitmap colorize filled-rectangle pict-height pict-width pin-over pin-under
                  scale)
         plot/no-gui
         (only-in plot/utils ->pen-color)
         (only-in racket/class send)
         (only-in racket/draw make-bitmap the-color-database)
         (only-in racket/math exact-round)
         "picture-layer.rkt" "pixels.rkt" "points.rkt")

(provide with-dense-points with-images-beneath named-color)

;; Pixels of the image in each pixel of the plot, so that it looks well on paper, too.
(define fineness 2)

;; p : a plot as a pict; layers : of points
(define (with-dense-points p bounds layers)
  (define-values (x y width height) (plot-area p bounds))
  (define image (make-pixels bounds (pixels-along width) (pixels-along height)))
  (for ([l (in-list layers)])
    (define s (layer-data l))
    (mark! image (snapshot-xs s) (snapshot-ys s) (snapshot-count s)
           (color->bytes (style-color (layer-style l)))
           (pixels-along (style-size (layer-style l)))))
  (pin-over p x y
            (scale (bytes->pict (pixels-width image) (pixels-height image) (pixels-bytes image))
                   (/ 1.0 fineness))))

(define (pixels-along length) (max 1 (exact-round (* fineness length))))

;; p : a plot without a background; layers : of rasters
(define (with-images-beneath p bounds layers)
  (define-values (x y width height) (plot-area p bounds))
  (define with-images
    (for/fold ([p p]) ([l (in-list (reverse layers))])
      (define r (layer-data l))
      (pin-under p x y
                 (scale (bytes->pict (raster-width r) (raster-height r) (raster-bytes r))
                        (/ width (raster-width r)) (/ height (raster-height r))))))
  (pin-under with-images 0 0
             (colorize (filled-rectangle (pict-width p) (pict-height p) #:draw-border? #f)
                       "white")))

;; -> x and y of the upper left corner, width and height of the area between the axes
(define (plot-area p bounds)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define place (plot-pict-plot->dc p))
  (define corner (place (vector x-min y-max)))
  (define opposite (place (vector x-max y-min)))
  (values (vector-ref corner 0) (vector-ref corner 1)
          (- (vector-ref opposite 0) (vector-ref corner 0))
          (- (vector-ref opposite 1) (vector-ref corner 1))))

(define (bytes->pict width height bytes)
  (define b (make-bitmap width height))
  (send b set-argb-pixels 0 0 width height bytes)
  (bitmap b))

;; c : a colour as plot takes it: a number, a name or three bytes
(define (color->bytes c)
  (define named (and (or (symbol? c) (string? c)) (named-color c)))
  (if named
      (list (send named red) (send named green) (send named blue))
      (->pen-color c)))

;; -> color% or #f
(define (named-color name) (send the-color-database find-color (format "~a" name)))
