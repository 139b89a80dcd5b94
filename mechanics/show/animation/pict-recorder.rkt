#lang racket/base
;; The drawing of a pict as elements of SVG.
;;
;; A pict draws on a canvas; this one keeps a record in place of making a picture.  Each line,
;; disc and text becomes an element by itself, in pixels, so that elements that stay the same
;; from one picture to the next can be told.  Gradients are drawn in their first color, and a
;; region that clips counts as the rectangle around it.

(require racket/class
         racket/draw
         racket/list
         racket/math
         (only-in pict draw-pict)
         "svg.rkt")

(provide record-pict)

;; -> list of svg.rkt's elements
(define (record-pict p)
  (define recorder (new recorder%))
  (draw-pict p recorder 0 0)
  (send recorder recorded))

;; Recorded elements, and the present pen, brush and transformation.
(define canvas%
  (class bitmap-dc%
    (super-new [bitmap (make-object bitmap% 1 1 #f #t)])
    (inherit get-pen get-brush get-alpha get-clipping-region
             get-transformation set-transformation translate)
    (define elements '())
    (define/public (recorded) (reverse elements))
    ;; the whole transformation as xx yx xy yy x0 y0, into which `translate` turns the present one
    (define/public (matrix)
      (define present (get-transformation))
      (translate 0 0)
      (begin0 (vector-ref (get-transformation) 0)
              (set-transformation present)))
    (define/public (present-look fill? rule)
      (look-of (get-pen) (if fill? (get-brush) no-brush) (get-alpha) (matrix) rule))
    (define/public (add! e)
      (define region (get-clipping-region))
      (define box
        (and region (call-with-values (lambda () (send region get-bounding-box)) vector)))
      (set! elements (cons (if box (clipped e box (matrix)) e) elements)))
    ;; make : dc-path% -> any, makes the outline
    (define/public (outline! make #:fill? [fill? #t] #:rule [rule 'odd-even])
      (define path (new dc-path%))
      (make path)
      (send path transform (matrix))
      (define l (present-look fill? rule))
      (when l (add! (path-element path l))))
    (define/override (clear) (set! elements '()))
    (define/override (erase) (set! elements '()))))

(define line-recorder%
  (class canvas%
    (super-new)
    (inherit outline! add! matrix present-look)
    (define/override (draw-line x1 y1 x2 y2)
      (outline! #:fill? #f (lambda (p) (send p move-to x1 y1) (send p line-to x2 y2))))
    (define/override (draw-lines points [dx 0] [dy 0])
      (outline! #:fill? #f (lambda (p) (connect! p points dx dy))))
    (define/override (draw-spline x1 y1 x2 y2 x3 y3)
      (outline! #:fill? #f
                (lambda (p) (send p move-to x1 y1) (send p curve-to x1 y1 x2 y2 x3 y3))))
    (define/override (draw-point x y)
      (define l (present-look #f 'odd-even))
      (when l (add! (dot-element (moved (matrix) x y) l))))))

(define area-recorder%
  (class line-recorder%
    (super-new)
    (inherit outline! add! matrix present-look)
    (define/override (draw-polygon points [dx 0] [dy 0] [rule 'odd-even])
      (outline! #:rule rule (lambda (p) (connect! p points dx dy) (send p close))))
    (define/override (draw-path path [dx 0] [dy 0] [rule 'odd-even])
      (outline! #:rule rule (lambda (p) (send p append path) (send p translate dx dy))))
    (define/override (draw-rectangle x y w h)
      (outline! (lambda (p) (send p rectangle x y w h))))
    (define/override (draw-rounded-rectangle x y w h [radius -0.25])
      (outline! (lambda (p) (send p rounded-rectangle x y w h radius))))
    (define/override (draw-arc x y w h from to)
      (outline! (lambda (p) (send p arc x y w h from to))))
    (define/override (draw-ellipse x y w h)
      (define m (matrix))
      (define l (present-look #t 'odd-even))
      (cond [(not (upright? m)) (outline! (lambda (p) (send p ellipse x y w h)))]
            [l (add! (ellipse-element (moved m (+ x (/ w 2)) (+ y (/ h 2)))
                                      (* (abs (vector-ref m 0)) (/ w 2))
                                      (* (abs (vector-ref m 3)) (/ h 2)) l))]))))

(define recorder%
  (class area-recorder%
    (super-new)
    (inherit add! matrix get-font get-alpha get-text-foreground get-text-extent)
    (define/override (draw-text text x y [combine? #t] [offset 0] [angle 0.0])
      (define-values (w h descent above) (get-text-extent text (get-font) combine? offset))
      (add! (text-element (substring text offset) x y w (- h descent) angle
                          (get-font) (get-text-foreground) (get-alpha) (matrix))))
    (define/override (draw-bitmap bitmap x y [style 'solid] [color #f] [mask #f])
      (draw-bitmap-section bitmap x y 0 0 (send bitmap get-width) (send bitmap get-height)
                           style color mask))
    (define/override (draw-bitmap-section bitmap x y from-x from-y w h
                                          [style 'solid] [color #f] [mask #f])
      (add! (image-element (section bitmap from-x from-y w h mask) x y w h (get-alpha) (matrix)))
      #t)))

;; points : pairs, or racket/draw's points; at least one
(define (connect! path points dx dy)
  (define first-one (first points))
  (define-values (x y)
    (if (pair? first-one)
        (values (car first-one) (cdr first-one))
        (values (send first-one get-x) (send first-one get-y))))
  (send path move-to (+ x dx) (+ y dy))
  (send path lines (rest points) dx dy))

(define no-brush (new brush% [style 'transparent]))

;; ---------------------------------------------------------------------------
;; Looks

;; The look of lines and areas under a transformation; #f if they are invisible.
(define (look-of pen brush alpha m rule)
  (define stroke? (not (eq? (send pen get-style) 'transparent)))
  (define fill (fill-color brush))
  (and (or stroke? fill)
       (look (and stroke? (color->css (send pen get-color) alpha))
             (max 0.5 (* (scale-of m) (max 0.5 (send pen get-width))))
             (dashes (send pen get-style))
             (and fill (color->css fill alpha))
             (eq? rule 'odd-even))))

(define (fill-color brush)
  (define gradient (send brush get-gradient))
  (cond [(eq? (send brush get-style) 'transparent) #f]
        [gradient (cadr (first (send gradient get-stops)))]
        [else (send brush get-color)]))

;; In widths of the line.
(define (dashes style)
  (case style
    [(dot) '(1 2)]
    [(long-dash) '(5 3)]
    [(short-dash) '(3 2)]
    [(dot-dash) '(1 2 4 2)]
    [else #f]))

;; ---------------------------------------------------------------------------
;; Transformations

(define (upright? m) (and (zero? (vector-ref m 1)) (zero? (vector-ref m 2))))

(define (scale-of m)
  (sqrt (abs (- (* (vector-ref m 0) (vector-ref m 3)) (* (vector-ref m 1) (vector-ref m 2))))))

(define (section bitmap x y w h mask)
  (define-values (wide high) (values (max 1 (exact-ceiling w)) (max 1 (exact-ceiling h))))
  (define out (make-object bitmap% wide high #f #t))
  (define canvas (new bitmap-dc% [bitmap out]))
  (send canvas draw-bitmap-section bitmap 0 0 x y w h 'solid (make-color 0 0 0) mask)
  out)
