#lang racket/base
;; The canvas of an exploration: points on a byte string of pixels, above the earlier contents of
;; the frame, with axes around.

(require racket/class
         (only-in racket/flonum ->fl)
         racket/gui/base
         "exploration.rkt" "../plot/pixels.rkt" "../plot/axes/plot-axes.rkt"
         "../plot/plot-canvas.rkt"
         "../plot/plot-colors.rkt" "../plot/axes/plot-ticks.rkt" "../plot/view.rkt")

(provide make-board board-canvas redraw-board! mark-on-board! board-picture
         ;; for tests: where a point of the plane is on the canvas
         board-place)

(define-values (left right top bottom) (values 56 12 12 28))
(define least-drag 5)            ; pixels; a shorter one is a click

;; background : device context, (x y -> pixel) -> any; on-point : x y -> any;
;; on-zoom : bounds -> any
;; pixels, bitmap : the contents, or #f; fresh? : does the bitmap show the pixels?
;; from, to : where the button went down, and where the mouse is now, pairs or #f
(struct board (exploration background on-point on-zoom
               [canvas #:mutable] [pixels #:mutable] [bitmap #:mutable] [fresh? #:mutable]
               [from #:mutable] [to #:mutable])
  #:authentic)

;; on-key : code -> any
(define (make-board window exploration background on-point on-zoom on-key)
  (define b (board exploration background on-point on-zoom #f #f #f #f #f #f))
  (set-board-canvas! b (new board-canvas% [parent window] [of b] [on-key on-key]))
  b)

(define board-canvas%
  (class canvas%
    (init-field of on-key)
    (inherit get-dc)
    (super-new)
    (define/override (on-paint) (paint of (get-dc)))
    (define/override (on-size width height) (redraw-board! of))
    (define/override (on-event event) (mouse! of event))
    (define/override (on-char event) (on-key (send event get-key-code)))))

;; ---------------------------------------------------------------------------
;; Contents

;; Draws everything again, after a change of the view or of the size.
(define (redraw-board! b)
  (define-values (width height) (send (board-canvas b) get-client-size))
  (define p
    (make-pixels (exploration-bounds (board-exploration b))
                 (max 20 (- width left right)) (max 20 (- height top bottom))))
  (define bitmap (make-bitmap (pixels-width p) (pixels-height p)))
  (put-background! b bitmap p)
  (each-orbit-marked (board-exploration b) p color->bytes)
  (set-board-pixels! b p)
  (set-board-bitmap! b bitmap)
  (changed! b))

(define (drawn-pixels b)
  (unless (board-pixels b) (redraw-board! b))
  (board-pixels b))

(define (changed! b)
  (set-board-fresh?! b #f)
  (send (board-canvas b) refresh))

(define (put-background! b bitmap p)
  (define dc (new bitmap-dc% [bitmap bitmap]))
  (send dc set-background "white")
  (send dc clear)
  ((board-background b) dc (lambda (x y) (point->pixel p x y)))
  (send bitmap get-argb-pixels 0 0 (pixels-width p) (pixels-height p) (pixels-bytes p)))

;; Marks new points of an orbit.
(define (mark-on-board! b xs ys count color)
  (mark! (drawn-pixels b) xs ys count (color->bytes color))
  (changed! b))

;; -> a bitmap of the whole canvas
(define (board-picture b)
  (define-values (width height) (send (board-canvas b) get-client-size))
  (define all (make-bitmap width height))
  (paint b (new bitmap-dc% [bitmap all]))
  all)

(define (paint b dc)
  (define p (drawn-pixels b))
  (define bitmap (board-bitmap b))
  (unless (board-fresh? b)
    (send bitmap set-argb-pixels 0 0 (pixels-width p) (pixels-height p) (pixels-bytes p))
    (set-board-fresh?! b #t))
  (send dc set-background "white")
  (send dc clear)
  (send dc draw-bitmap bitmap left top)
  (draw-frame dc p)
  (when (and (board-from b) (board-to b)) (draw-selection dc (board-from b) (board-to b))))

;; ---------------------------------------------------------------------------
;; The mouse

(define (mouse! b event)
  (define at (cons (send event get-x) (send event get-y)))
  (define from (board-from b))
  (cond [(send event button-down? 'left) (drag! b at #f)]
        [(and from (send event dragging?))
         (drag! b from at)
         (send (board-canvas b) refresh)]
        [(and from (send event button-up? 'left))
         (drag! b #f #f)
         (release b from at)]))

(define (drag! b from to)
  (set-board-from! b from)
  (set-board-to! b to))

(define (release b start end)
  (define-values (x1 y1) (point-at b start))
  (define-values (x2 y2) (point-at b end))
  (cond [(and (< (abs (- (car start) (car end))) least-drag)
              (< (abs (- (cdr start) (cdr end))) least-drag))
         ((board-on-point b) x1 y1)]
        [(or (= x1 x2) (= y1 y2)) (send (board-canvas b) refresh)]
        [else ((board-on-zoom b) (list (min x1 x2) (max x1 x2) (min y1 y2) (max y1 y2)))]))

(define (point-at b place)
  (pixel->point (drawn-pixels b) (- (car place) left) (- (cdr place) top)))

(define (board-place b x y)
  (define-values (i j) (point->pixel (drawn-pixels b) x y))
  (values (+ left i) (+ top j)))

;; ---------------------------------------------------------------------------

;; The axes of a picture (show/plot/axes/plot-axes.rkt) around the contents
(define (draw-frame dc p)
  (define-values (x-min x-max y-min y-max) (apply values (pixels-bounds p)))
  (define-values (width height) (values (pixels-width p) (pixels-height p)))
  (define a
    (area (view (pixels-bounds p) #f #f #f width height #f '(linear linear))
          #f
          (ticks-between x-min x-max) (ticks-between y-min y-max)
          (->fl left) (->fl (+ left width)) (->fl top) (->fl (+ top height))))
  (call-with-canvas dc 0 0 (lambda () (draw-axes dc a))))

(define (draw-selection dc from to)
  (send dc set-pen "gray" 1 'short-dash)
  (send dc set-brush "white" 'transparent)
  (send dc draw-rectangle
        (min (car from) (car to)) (min (cdr from) (cdr to))
        (abs (- (car from) (car to))) (abs (- (cdr from) (cdr to)))))
