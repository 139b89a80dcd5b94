#lang racket/base
;; Layers drawn.  This is the part that needs the libraries of racket/draw.

(require (only-in racket/class new send)
         (only-in racket/draw bitmap-dc% make-bitmap region%)
         (only-in racket/flonum for/flvector in-flvector)
         "clipped-lines.rkt" "level-lines.rkt" "picture-layer.rkt" "axes/plot-axes.rkt"
         "plot-canvas.rkt" "plot-colors.rkt" "plot-images.rkt" "axes/plot-legend.rkt" "points.rkt"
         "view.rkt")

(provide loaded? color-name? draw-picture picture-point)

;; A call of it loads this module: so a caller learns whether that is possible.
(define (loaded?) #t)

;; ---------------------------------------------------------------------------

;; x, y : where the upper left corner is to be
;; Images are beneath the axes; above are the layers, then all that have very many points, as one
;; image, and the legend.
(define (draw-picture dc given-view given-layers x y)
  (define v (with-logarithms given-view))
  (define layers (map (layer-with-logarithms v) (sized v given-layers)))
  (define (draw)
    (define a (plot-area dc v (bar-of layers)))
    (draw-box dc 0 0 (view-width v) (view-height v) "white" #f)
    (for ([l (in-list layers)] #:when (eq? (layer-kind l) 'image))
      (draw-raster dc a (layer-data l)))
    (draw-axes dc a)
    (define outside (send dc get-clipping-region))
    (clip-to! dc a outside)
    (for ([l (in-list layers)] #:unless (dense? l)) (draw-layer dc a l))
    (define dense (filter dense? layers))
    (unless (null? dense) (draw-dense-points dc a dense))
    (send dc set-clipping-region outside)
    (draw-legend dc a layers))
  (call-with-canvas dc x y draw))

(define (bar-of layers)
  (for/or ([l (in-list layers)] #:when (eq? (layer-kind l) 'image)) (raster-bar (layer-data l))))

;; The lines of the axes are within.
(define (clip-to! dc a outside)
  (define region (new region% [dc dc]))
  (send region set-rectangle (- (area-left a) 1/2) (- (area-top a) 1/2)
        (+ (- (area-right a) (area-left a)) 1) (+ (- (area-bottom a) (area-top a)) 1))
  (when outside (send region intersect outside))
  (send dc set-clipping-region region))

;; v : with plain axes; across, down : a place as shares of the picture's width and height
;; -> x and y of the plane
(define (picture-point v layers across down)
  (define dc (new bitmap-dc% [bitmap (make-bitmap 1 1)]))
  (define a #f)
  (call-with-canvas dc 0 0 (lambda () (set! a (plot-area dc v (bar-of layers)))))
  (define-values (x-min x-max y-min y-max) (apply values (view-bounds v)))
  (define (between low high place from to)
    (+ low (* (- high low) (/ (- place from) (- to from)))))
  (values (between x-min x-max (* across (view-width v)) (area-left a) (area-right a))
          (between y-min y-max (* down (view-height v)) (area-bottom a) (area-top a))))

;; A picture with logarithmic axes is one of logarithms: numbers without one are left out.
(define (with-logarithms v)
  (define-values (x y) (apply values (view-scales v)))
  (struct-copy view v [bounds (map decimal-logarithm (view-bounds v) (list x x y y))]))

(define (decimal-logarithm x scale)
  (cond [(eq? scale 'linear) x] [(> x 0.0) (log x 10.0)] [else +nan.0]))

(define ((layer-with-logarithms v) l)
  (define data (layer-data l))
  (define-values (x-scale y-scale) (apply values (view-scales v)))
  (define (changed xs scale)
    (for/flvector #:length (snapshot-count data)
                  ([x (in-flvector xs 0 (snapshot-count data))])
      (decimal-logarithm x scale)))
  (if (and (snapshot? data) (not (plain-axes? v)))
      (layer (layer-style l)
             (snapshot (changed (snapshot-xs data) x-scale)
                       (changed (snapshot-ys data) y-scale)
                       (snapshot-count data)))
      l))

(define (draw-layer dc a l)
  (define-values (s data place) (values (layer-style l) (layer-data l) (area-place a)))
  (define (draw lines)
    (draw-strokes dc lines (color->bytes (style-color s)) (style-size s) (style-dash s)))
  (define (placed points) (for/list ([p (in-list points)]) (place (car p) (cdr p))))
  (case (layer-kind l)
    [(points) (draw (for/list ([p (in-list (places data place))]) (list p p)))]
    [(lines curve) (draw (clipped-lines (places data place) (area-left a) (area-right a)
                                        (area-top a) (area-bottom a)))]
    [(level) (draw (map placed (level-lines data (view-bounds (area-view a)))))]
    [else (void)]))

(define (places points place)
  (define count (snapshot-count points))
  (for/list ([x (in-flvector (snapshot-xs points) 0 count)]
             [y (in-flvector (snapshot-ys points) 0 count)])
    (place x y)))

;; A layer with more points is drawn as an image, not point by point.
(define many-points 20000)

(define (dense? l)
  (and (eq? (layer-kind l) 'points) (> (snapshot-count (layer-data l)) many-points)))

;; ---------------------------------------------------------------------------
;; The size of points

;; Points that do not say how large they are cover a twentieth of the picture together, but none is
;; larger than 5 pixels or smaller than 2; where that would cover it twice they are smaller.
(define (size-of-points count area)
  (define (covering share) (sqrt (/ (* share area) (max 1 count))))
  (max 1.0 (min 5.0 (covering 0.05)) (min 2.0 (covering 2.0))))

(define (sized v layers)
  (define (unsized? l) (not (style-size (layer-style l))))
  (define count
    (for/sum ([l (in-list layers)] #:when (unsized? l)) (snapshot-count (layer-data l))))
  (define size (size-of-points count (* (view-width v) (view-height v))))
  (for/list ([l (in-list layers)])
    (if (unsized? l)
        (struct-copy layer l [style (struct-copy style (layer-style l) [size size])])
        l)))
