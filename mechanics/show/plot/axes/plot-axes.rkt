#lang racket/base
;; The frame of a picture: title, axes with ticks on four sides, numbers and labels, and the area
;; between the axes, which is as large as these leave it.

(require (only-in racket/class send)
         (only-in racket/math exact-round)
         "color-bar.rkt" "../plot-canvas.rkt" "plot-ticks.rkt" "../view.rkt")

(provide plot-area (struct-out area) area-place draw-axes)

;; bar : a color-bar to the right, or #f; x-ticks, y-ticks : of plot-ticks.rkt; left, right, top,
;; bottom : the edges, flonums, in pixels
(struct area (view bar x-ticks y-ticks left right top bottom))

(define tick-length 5)           ; to either side of the axis; half of it without a number
(define gap 7)                   ; from an axis to its numbers

;; -> procedure: x, y of the plane -> pair, its place in pixels
(define (area-place a)
  (define-values (x-min x-max y-min y-max) (apply values (view-bounds (area-view a))))
  (define-values (left bottom) (values (area-left a) (area-bottom a)))
  (define-values (width height) (values (- (area-right a) left) (- bottom (area-top a))))
  (define-values (across up) (values (share-between x-min x-max) (share-between y-min y-max)))
  (lambda (x y) (cons (+ left (* width (across x))) (- bottom (* height (up y))))))

;; -> procedure: x -> 0 at the low end, 1 at the high one, though their difference may be infinite
(define (share-between low high)
  (define unit (if (< (- high low) +inf.0) 1.0 0.5))
  (define-values (from range) (values (* unit low) (- (* unit high) (* unit low))))
  (lambda (x) (/ (- (* unit x) from) range)))

(define (x-place a x) (car ((area-place a) x 0.0)))
(define (y-place a y) (cdr ((area-place a) 0.0 y)))

;; ---------------------------------------------------------------------------
;; Layout

;; The bounds of a logarithmic axis are logarithms.
(define (ticks low high scale)
  ((if (eq? scale 'log) log-ticks-between ticks-between) low high))

;; Margins grow by texts that stick out.  As these move with the area, margins grow again;
;; where nothing would remain there are none.
(define (plot-area dc v bar)
  (define-values (x-min x-max y-min y-max) (apply values (view-bounds v)))
  (define-values (x-ticks y-ticks) (values (ticks x-min x-max (car (view-scales v)))
                                           (ticks y-min y-max (cadr (view-scales v)))))
  (define-values (width height) (values (view-width v) (view-height v)))
  (define head (if (view-title v) (* 3/2 (text-height (title-text dc v))) 0))
  (let grow ([left 0] [right width] [top head] [bottom height] [rounds 3])
    (define (between left right top bottom)
      (apply area v bar x-ticks y-ticks (map real->double-flonum (list left right top bottom))))
    (define a (between left right top bottom))
    (define-values (x1 x2 y1 y2) (extent dc a))
    (cond [(or (>= left right) (>= top bottom)) (between 0 width head height)]
          [(= rounds 0) (in-ratio a)]
          [else (grow (exact-round (- left (min 0 x1)))
                      (exact-round (- right (max 0 (- x2 (- width 1)))))
                      (exact-round (- top (min 0 (- y1 head))))
                      (exact-round (- bottom (max 0 (- y2 (- height 1)))))
                      (- rounds 1))])))

;; -> least and greatest x and y of ticks, numbers and labels
(define (extent dc a)
  (for/fold ([x1 (- (area-left a) tick-length)] [x2 (+ (area-right a) tick-length)]
             [y1 (- (area-top a) tick-length)] [y2 (+ (area-bottom a) tick-length)])
            ([t (in-list (texts dc a))])
    (values (min x1 (text-left t)) (max x2 (+ (text-left t) (text-width t)))
            (min y1 (text-top t)) (max y2 (+ (text-top t) (text-height t))))))

;; The greatest area of the view's ratio that a holds, in its middle
(define (in-ratio a)
  (define ratio (view-aspect-ratio (area-view a)))
  (define-values (width height)
    (values (- (area-right a) (area-left a)) (- (area-bottom a) (area-top a))))
  (define (spare length wanted) (if ratio (/ (max 0 (- length wanted)) 2) 0))
  (define dx (spare width (* height (or ratio 1))))
  (define dy (spare height (/ width (or ratio 1))))
  (struct-copy area a
               [left (+ (area-left a) dx)] [right (- (area-right a) dx)]
               [top (+ (area-top a) dy)] [bottom (- (area-bottom a) dy)]))

;; ---------------------------------------------------------------------------
;; Numbers and labels

;; -> list of text
(define (texts dc a)
  (define-values (left bottom v) (values (area-left a) (area-bottom a) (area-view a)))
  (define below
    (for/list ([t (in-list (area-x-ticks a))] #:when (tick-label t))
      (make-text dc (tick-label t) (x-place a (tick-value t)) (+ bottom gap) 1/2 0)))
  (define beside
    (for/list ([t (in-list (area-y-ticks a))] #:when (tick-label t))
      (make-text dc (tick-label t) (- left gap) (y-place a (tick-value t)) 1 1/2)))
  (define half-line (/ (send dc get-char-height) 2))
  (define under (+ bottom gap half-line (apply max 0 (map text-height below))))
  (define aside (- left gap half-line (apply max 0 (map text-width beside))))
  (define (label string x y across down turned?)
    (if string (list (make-text dc string x y across down turned?)) '()))
  (append below beside
          (if (area-bar a) (bar-texts dc (area-bar a) (area-right a) (area-top a) bottom) '())
          (label (view-x-label v) (/ (+ left (area-right a)) 2) under 1/2 0 #f)
          (label (view-y-label v) aside (/ (+ (area-top a) bottom) 2) 1 1/2 #t)))

;; ---------------------------------------------------------------------------

(define (draw-axes dc a)
  (define-values (left right top bottom v)
    (values (area-left a) (area-right a) (area-top a) (area-bottom a) (area-view a)))
  (draw-box dc left top (- right left) (- bottom top) #f 0.5)
  (for ([number? (in-list '(#f #t))] [width (in-list '(0.5 1))])
    (define length (if number? tick-length (/ tick-length 2)))
    (define (ticks-of all) (filter (lambda (t) (eq? number? (and (tick-label t) #t))) all))
    (draw-strokes
     dc
     (append
      (for*/list ([t (in-list (ticks-of (area-x-ticks a)))] [y (in-list (list bottom top))])
        (define x (x-place a (tick-value t)))
        (list (cons x (- y length)) (cons x (+ y length))))
      (for*/list ([t (in-list (ticks-of (area-y-ticks a)))] [x (in-list (list left right))])
        (define y (y-place a (tick-value t)))
        (list (cons (- x length) y) (cons (+ x length) y))))
     '(0 0 0) width))
  (when (area-bar a) (draw-color-bar dc (area-bar a) right top bottom))
  (for ([t (in-list (texts dc a))]) (draw-text dc t))
  (when (view-title v) (draw-text dc (title-text dc v))))

(define (title-text dc v) (make-text dc (view-title v) (/ (view-width v) 2) 0 1/2 0))
