#lang racket/base
;; Images in a picture: very many points as one, in place of a dot for each; and colours of parts of
;; the plane.

(require (only-in racket/class send send*)
         (only-in racket/draw make-bitmap)
         (only-in racket/math exact-round)
         "picture-layer.rkt" "pixels.rkt" "axes/plot-axes.rkt" "plot-colors.rkt" "points.rkt"
         "view.rkt")

(provide draw-dense-points draw-raster)

;; Pixels of the image in each pixel of the picture, so that it looks well on paper, too.
(define fineness 2)

;; layers : of points
(define (draw-dense-points dc a layers)
  (define (pixels-along length) (max 1 (exact-round (* fineness length))))
  (define image
    (make-pixels (view-bounds (area-view a))
                 (pixels-along (- (area-right a) (area-left a)))
                 (pixels-along (- (area-bottom a) (area-top a)))))
  (for ([l (in-list layers)])
    (define-values (s points) (values (layer-style l) (layer-data l)))
    (mark! image (snapshot-xs points) (snapshot-ys points) (snapshot-count points)
           (color->bytes (style-color s)) (pixels-along (style-size s))))
  (draw-image dc a (pixels-width image) (pixels-height image) (pixels-bytes image)))

(define (draw-raster dc a r)
  (define (times cells length) (max 1 (exact-round (/ (* fineness length) cells))))
  (define-values (width height) (values (raster-width r) (raster-height r)))
  (define-values (k l) (values (times width (- (area-right a) (area-left a)))
                               (times height (- (area-bottom a) (area-top a)))))
  (draw-image dc a (* k width) (* l height) (enlarged (raster-bytes r) width height k l)))

;; Each pixel k wide and l high: where it is enlarged by others, its colour runs into the next.
(define (enlarged bytes width height k l)
  (define (repeated n part) (apply bytes-append (for/list ([_ (in-range n)]) part)))
  (define (pixel i j) (subbytes bytes (* 4 (+ i (* j width))) (* 4 (+ 1 i (* j width)))))
  (apply bytes-append
         (for/list ([j (in-range height)])
           (repeated l (apply bytes-append
                              (for/list ([i (in-range width)]) (repeated k (pixel i j))))))))

;; Fills the area with the image.
(define (draw-image dc a width height bytes)
  (define image (make-bitmap width height))
  (send image set-argb-pixels 0 0 width height bytes)
  (define place (send dc get-transformation))
  (send* dc
    (translate (area-left a) (area-top a))
    (scale (/ (- (area-right a) (area-left a)) width 1.0)
           (/ (- (area-bottom a) (area-top a)) height 1.0))
    (draw-bitmap image 0 0)
    (set-transformation place)))
