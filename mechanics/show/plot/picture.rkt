#lang racket/base
;; Layers turned into a picture by Racket's plot library.  This is the part that takes
;; a second to load, and that needs the libraries of racket/draw.

(require file/convertible
         (only-in pict unsafe-dc)
         plot/no-gui
         (only-in racket/math exact-round)
         "picture-layer.rkt" "plot-images.rkt" "points.rkt" "view.rkt")

(provide loaded? color-name? make-picture picture-bytes)

;; A call of it loads this module: so a caller learns whether that is possible.
(define (loaded?) #t)

(define (color-name? name) (and (named-color name) #t))

;; -> pict
(define (make-picture v given-layers)
  (define layers (sized v given-layers))
  (define dense (filter dense? layers))
  (define images (filter image? layers))
  (if (and (null? dense) (null? images))
      (drawn-once v layers)
      (composed v layers dense images)))

;; As plot-pict makes one, which draws each plot a second time, as a check that the canvas is
;; as it was after that; the library has it so.
(define (drawn-once v layers)
  (define drawn (renderers v layers))
  (define settings (current-parameterization))
  (define-values (width height) (values (view-width v) (view-height v)))
  (unsafe-dc (lambda (canvas x y)
               (call-with-parameterization
                settings (lambda () (plotted plot/dc v drawn canvas x y width height))))
             width height))

;; Calls one of the library's procedures with the arguments and all that the view says.
(define-syntax-rule (plotted plot v argument ...)
  (let-values ([(x-min x-max y-min y-max) (apply values (view-bounds v))])
    (plot argument ...
          #:x-min x-min #:x-max x-max #:y-min y-min #:y-max y-max
          #:title (view-title v) #:x-label (view-x-label v) #:y-label (view-y-label v)
          #:aspect-ratio (view-aspect-ratio v))))

;; The first point stands for those of a layer that is drawn as an image.
(define (renderers v layers)
  (for/list ([l (in-list layers)])
    (layer->renderer (if (dense? l) (first-point l) l) (view-bounds v))))

;; Very many points are one image, above the rest; images are beneath it.  The first of the
;; points, and one of an image, are drawn none the less, for the legend and the axes.
(define (composed v layers dense images)
  (define bounds (view-bounds v))
  (define drawn
    (parameterize ([plot-background-alpha (if (null? images) 1 0)])
      (plotted plot-pict v (renderers v layers)
               #:width (view-width v) #:height (view-height v))))
  (define with-points (if (null? dense) drawn (with-dense-points drawn bounds dense)))
  (if (null? images) with-points (with-images-beneath with-points bounds images)))

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

;; ---------------------------------------------------------------------------

(define (image? l) (eq? (layer-kind l) 'image))

;; A layer with more points is drawn as an image, not point by point.
(define many-points 20000)

(define (dense? l)
  (and (eq? (layer-kind l) 'points) (> (snapshot-count (layer-data l)) many-points)))

(define (first-point l)
  (layer (layer-style l) (struct-copy snapshot (layer-data l) [count 1])))

;; format : as `convert` names it, 'png-bytes and so on
(define (picture-bytes v layers format default)
  (convert (make-picture v layers) format default))

(define (layer->renderer l bounds)
  (define s (layer-style l))
  (define data (layer-data l))
  (case (layer-kind l)
    [(points)
     ;; plot's dots are a quarter as wide as their size says
     (points (snapshot->vectors data)
             #:sym 'dot #:size (* 4 (style-size s)) #:color (style-color s)
             #:label (style-label s))]
    [(image)
     (define-values (x-min x-max y-min y-max) (apply values bounds))
     (points (list (vector x-min y-min)) #:alpha 0)]
    [(level)
     (define-values (x-min x-max y-min y-max) (apply values bounds))
     (isoline (field-function data bounds) (field-level data) x-min x-max y-min y-max
              #:samples (field-count data)
              #:color (style-color s) #:width (style-size s) #:style (style-dash s)
              #:label (style-label s))]
    [else
     (lines (snapshot->vectors data)
            #:color (style-color s) #:width (style-size s) #:style (style-dash s)
            #:label (style-label s))]))

;; The sampled function: the plot library asks for it at the nodes again.
(define ((field-function f bounds) x y)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define last (- (field-count f) 1))
  (define (index x low high)
    (max 0 (min last (exact-round (* last (/ (- x low) (- high low)))))))
  (vector-ref (vector-ref (field-rows f) (index y y-min y-max)) (index x x-min x-max)))
