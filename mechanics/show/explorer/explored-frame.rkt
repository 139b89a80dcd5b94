#lang racket/base
;; A map explored in its frame, where someone else shows the picture and tells of clicks: a
;; notebook.
;;
;; The frame holds its former layers, and above them the orbits, always as they are now: whoever
;; takes it later has these, too.  Orbits grow in a thread of their own (orbit-worker.rkt).

(require racket/flonum
         "exploration.rkt" "orbit-worker.rkt" "../plot/frame.rkt" "../plot/picture-layer.rkt"
         "../plot/plot-colors.rkt" "../plot/points.rkt" "../plot/style.rkt" "../plot/view.rkt"
         (only-in "../plot/on-demand.rkt" picture-point)
         (only-in "../display/program-end.rkt" current-picture-watcher))

(provide open-explored-frame act-on! wait-for-points explored-picture explored-text)

;; left : orbit -> how many of its points are to come; turn : the worker and others take turns
;; drawn : layers of orbits in the frame; remark : why an orbit ended last, or #f
(struct explored (who frame exploration left turn [drawn #:mutable] [worker #:mutable]
                      [remark #:mutable])
  #:authentic)

;; starts : list of pairs
(define (open-explored-frame who f map n starts)
  (define e (make-exploration map n (frame-bounds f)))
  (define x (explored who f e (make-hasheq) (make-semaphore 1) '() #f #f))
  (define (receive . news) (in-turn x (lambda () (apply take! x news))))
  (set-explored-worker! x (start-worker map receive))
  (for ([p (in-list starts)]) (start-orbit! x (car p) (cdr p)))
  x)

(define (in-turn x f)
  (parameterize-break #f (call-with-semaphore (explored-turn x) f)))

(define (start-orbit! x px py) (grow! x (add-orbit! (explored-exploration x) px py) 1))

;; first : the start, which is a point as well
(define (grow! x o [first 0])
  (define n (exploration-n (explored-exploration x)))
  (hash-update! (explored-left x) o (lambda (left) (+ left n first)) 0)
  (ask-worker (explored-worker x) o n))

;; Points from the worker; why : the orbit ends, or #f
(define (take! x o xs ys count why)
  (add-points! (explored-exploration x) o xs ys count)
  (set-explored-remark! x (and why (format "an orbit ends: ~a" why)))
  (hash-update! (explored-left x) o (lambda (left) (if why 0 (- left count))) 0))

(define (growing? x)
  (for/or ([t (in-list (exploration-orbits (explored-exploration x)))])
    (define o (traced-orbit t))
    (and (not (orbit-stopped? o)) (positive? (hash-ref (explored-left x) o 0)))))

;; ---------------------------------------------------------------------------
;; Actions of the reader

(define least-drag 5)            ; pixels; a shorter one is a click

;; action : "undo", "more", "whole", "clear", or "point", between two places in the picture
;; place : from x, from y, to x, to y, as shares of the picture's width and height from the top left
(define (act-on! x action [place '()])
  (define e (explored-exploration x))
  (in-turn x (lambda ()
               (set-explored-remark! x #f)
               (case action
                 [("undo") (undo! e)]
                 [("whole") (whole! e)]
                 [("clear") (clear! e)]
                 [("more") (for ([t (in-list (exploration-orbits e))]) (grow! x (traced-orbit t)))]
                 [("point") (apply point! x place)]))))

;; Where the view is not, nothing happens.
(define (point! x from-x from-y to-x to-y)
  (define-values (f v) (values (explored-frame x) (view-now x)))
  (define layers (if (whole? f v) (frame-layers f) '()))
  (define-values (x1 y1) (picture-point v layers from-x from-y))
  (define-values (x2 y2) (picture-point v layers to-x to-y))
  (define-values (x-min x-max y-min y-max) (apply values (view-bounds v)))
  (define (within low high z) (max low (min high z)))
  (define zoomed
    (list (within x-min x-max (min x1 x2)) (within x-min x-max (max x1 x2))
          (within y-min y-max (min y1 y2)) (within y-min y-max (max y1 y2))))
  (define click?
    (and (< (abs (* (view-width v) (- to-x from-x))) least-drag)
         (< (abs (* (view-height v) (- to-y from-y))) least-drag)))
  (cond [click? (when (and (<= x-min x1 x-max) (<= y-min y1 y-max)) (start-orbit! x x1 y1))]
        [(and (< (car zoomed) (cadr zoomed)) (< (caddr zoomed) (cadddr zoomed)))
         (zoom! (explored-exploration x) zoomed)]))

;; A part of the plane takes all of the picture.
(define (view-now x)
  (define-values (v bounds)
    (values (frame-view (explored-frame x)) (exploration-bounds (explored-exploration x))))
  (if (equal? bounds (view-bounds v)) v (struct-copy view v [bounds bounds] [aspect-ratio #f])))

;; Waits for the points to come, some quarter of a second at most -> are there more to come?
(define (wait-for-points x)
  (define end (+ (current-inexact-milliseconds) 250.0))
  (let loop ()
    (cond [(not (growing? x)) #f]
          [(> (current-inexact-milliseconds) end) #t]
          [else (sleep 0.01) (loop)])))

;; ---------------------------------------------------------------------------
;; Text and picture

(define (explored-text x)
  (or (explored-remark x) (exploration->text (explored-exploration x))))

;; -> the frame, or another one where a part of it is on view
(define (explored-picture x)
  (parameterize ([current-picture-watcher #f])
    (define-values (f v) (values (explored-frame x) (view-now x)))
    (define others (remq* (explored-drawn x) (frame-layers f)))
    (set-explored-drawn! x (orbit-layers x (frame-bounds f)))
    (replace-layers! (explored-who x) f (append (explored-drawn x) others))
    (if (whole? f v) f (part x v others))))

(define (whole? f v) (equal? (view-bounds v) (frame-bounds f)))

;; Levels and images are of the whole frame.
(define (part x v others)
  (define f
    (apply frame (view-bounds v) #:title (view-title v) #:x-label (view-x-label v)
           #:y-label (view-y-label v) #:width (view-width v) #:height (view-height v)))
  (define movable
    (filter (lambda (l) (memq (layer-kind l) '(points lines curve))) others))
  (replace-layers! (explored-who x) f (append (orbit-layers x (view-bounds v)) movable))
  f)

;; -> a layer for each orbit, the latest first, of its points within the bounds
(define (orbit-layers x bounds)
  (define-values (x-min x-max y-min y-max) (apply values bounds))
  (define layers '())
  (for-each-orbit
   (explored-exploration x)
   (lambda (color xs ys count)
     (define inside (make-points))
     (for ([px (in-flvector xs 0 count)] [py (in-flvector ys 0 count)]
           #:when (and (<= x-min px x-max) (<= y-min py y-max)))
       (add-point! inside px py))
     ;; a colour by its bytes: points drawn in the same one later are no part of this layer
     (define s (make-style (explored-who x) 'points (color->bytes color) #f 'solid #f))
     (set! layers (cons (layer s inside) layers))))
  layers)
