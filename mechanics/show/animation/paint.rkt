#lang racket/base
;; Shapes as a pict.  Here their units become pixels, and y is turned upside down.

(require (only-in pict unsafe-dc)
         racket/class
         racket/draw
         racket/math
         "shapes.rkt"
         "../typesetting/drawing-state.rkt"
         "../../error/complain.rkt")

(provide loaded? paint)

;; A call of it loads this module: so a caller learns whether that is possible.
(define (loaded?) #t)

;; bounds : (list x-min x-max y-min y-max); width : pixels; the height follows.
(define (paint bounds width shapes)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define scale (/ width (- x-max x-min)))
  (define height (* scale (- y-max y-min)))
  (define (draw canvas dx dy)
    (define (place p)
      (values (+ dx (* scale (- (vector-ref p 0) x-min)))
              (+ dy (* scale (- y-max (vector-ref p 1))))))
    (call-restoring-state
     canvas
     (lambda ()
       (send canvas set-smoothing 'smoothed)
       (for ([s (in-list shapes)]) (paint-shape s canvas place scale)))))
  (unsafe-dc draw width height))

(define (paint-shape s canvas place scale)
  (cond [(stroke? s) (paint-stroke s canvas place)]
        [(spot? s) (paint-spot s canvas place scale)]
        [else (paint-lettering s canvas place)]))

;; ---------------------------------------------------------------------------
;; Lines and discs

(define (paint-stroke s canvas place)
  (define points
    (for/list ([p (in-list (stroke-points s))])
      (define-values (x y) (place p))
      (cons x y)))
  (set-pen! canvas (stroke-color s) (stroke-width s) (stroke-dash s))
  (set-brush! canvas (stroke-fill s))
  (if (or (stroke-closed? s) (stroke-fill s))
      (send canvas draw-polygon points)
      (send canvas draw-lines points))
  (unless (eq? (stroke-heads s) 'none)
    (paint-head canvas s (reverse points))
    (when (eq? (stroke-heads s) 'both) (paint-head canvas s points))))

(define head-length 9.0)         ; pixels
(define head-angle (/ pi 8))

;; Draws an arrow head with its tip at the first point.  Its direction comes from the first point
;; that is about as far away as the head is long: a curve may begin with short pieces.
(define (paint-head canvas s points)
  (define tip (car points))
  (define (away p) (magnitude (make-rectangular (- (car p) (car tip)) (- (cdr p) (cdr tip)))))
  (define tail
    (or (findf (lambda (p) (>= (away p) (* 0.7 head-length))) (cdr points))
        (car (reverse points))))
  (when (> (away tail) 0)
    (define direction (atan (- (cdr tail) (cdr tip)) (- (car tail) (car tip))))
    (define (corner angle)
      (cons (+ (car tip) (* head-length (cos (+ direction angle))))
            (+ (cdr tip) (* head-length (sin (+ direction angle))))))
    (set-pen! canvas (stroke-color s) 1 'solid)
    (set-brush! canvas (stroke-color s))
    (send canvas draw-polygon (list tip (corner head-angle) (corner (- head-angle))))))

(define (paint-spot s canvas place scale)
  (define r (* scale (spot-radius s)))
  (define-values (x y) (place (spot-center s)))
  (set-pen! canvas (spot-color s) (spot-width s) 'solid)
  (set-brush! canvas (spot-fill s))
  (send canvas draw-ellipse (- x r) (- y r) (* 2 r) (* 2 r)))

(define (set-pen! canvas color width dash)
  (send canvas set-pen (color-of (or color ink)) width (if color dash 'transparent)))

(define (set-brush! canvas fill)
  (send canvas set-brush (color-of (or fill ink)) (if fill 'solid 'transparent)))

(define (color-of c)
  (cond [(list? c) (apply make-color c)]
        [else
         (define name (if (symbol? c) (symbol->string c) c))
         (or (send the-color-database find-color name)
             (complain 'color "there is no color of that name\n  given: ~v" c))]))

;; ---------------------------------------------------------------------------
;; Letters

(define gap 5.0)                 ; pixels, between a point and its neighbour

;; Letters in a row, of an index or not: "θ_1 + x" has "θ", "1" and " + x".
(struct run (text index?))

(define (runs text)
  (for*/list ([m (in-list (regexp-match* #px"_([[:alnum:]]+)|([^_]+|_)" text
                                         #:match-select values))])
    (if (cadr m) (run (cadr m) #t) (run (car m) #f))))

(define (paint-lettering s canvas place)
  (define all (runs (lettering-text s)))
  (define (font-of index?) (letters s (if index? 0.72 1.0)))
  (define sizes
    (for/list ([r (in-list all)])
      (define-values (w h descent above)
        (send canvas get-text-extent (run-text r) (font-of (run-index? r)) #t))
      w))
  (define-values (ww height d a) (send canvas get-text-extent "x" (font-of #f) #t))
  (define-values (x y) (place (lettering-at s)))
  (define-values (left top) (corner-of (lettering-anchor s) (apply + sizes) height))
  (send canvas set-text-foreground (color-of (or (lettering-color s) ink)))
  (for/fold ([x (+ x left (vector-ref (lettering-shift s) 0))])
            ([r (in-list all)] [w (in-list sizes)])
    (define lowered (if (run-index? r) (* 0.45 height) 0.0))
    (send canvas set-font (font-of (run-index? r)))
    (send canvas draw-text (run-text r) x
          (+ y top lowered (- (vector-ref (lettering-shift s) 1))) #t)
    (+ x w))
  (void))

(define (letters s share)
  (make-font #:size (* share (lettering-size s)) #:size-in-pixels? #t #:family 'roman
             #:style (if (lettering-italic? s) 'italic 'normal)))

;; -> the offset from the point to the upper left corner of the text
(define (corner-of anchor width height)
  (case anchor
    [(left) (values (- (+ width gap)) (* -0.5 height))]
    [(right) (values gap (* -0.5 height))]
    [(above) (values (* -0.5 width) (- (+ height gap)))]
    [(below) (values (* -0.5 width) gap)]
    [else (values (* -0.5 width) (* -0.5 height))]))
