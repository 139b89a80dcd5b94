#lang racket/base
;; The pictures of an animation: at any time the mechanism, with its trail beneath it, and
;; beside it the phase portrait.  Each of the two is a panel.

(require racket/flonum
         racket/list
         (only-in racket/math exact-ceiling exact-floor)
         (only-in pict pict? pict-width pict-height blank lt-superimpose hc-append)
         "drawing.rkt" "film.rkt" "paint.rkt" "phase-plane.rkt" "portrait-shapes.rkt"
         "shapes.rkt"
         "../../error/complain.rkt" "../../error/computed-once.rkt"
         "../../generic/describe.rkt"
         "../../numeric/finite-number.rkt")

(provide make-scenery check-picture scenery->pict scenery-size
         scenery-film scenery-panels
         panel-width panel-height panel-picture panel-trails
         trail-detail)

;; panels : one or two
(struct scenery (film panels))

;; width, height : pixels
;; picture  : time -> pict, without the trail
;; trails   : -> list of flvectors x y x y ... in pixels, y down, of one length: the points of
;;            all trails at the pictures' times, with trail-detail - 1 more between each two
;; trail-at : time -> pict or #f
(struct panel (width height picture trails trail-at))

(define trail-detail 4)

(define (make-scenery f)
  (define mechanism (mechanism-panel f))
  (scenery f (if (film-plane f) (list mechanism (portrait-panel f)) (list mechanism))))

;; -> the whole picture at time t
(define (scenery->pict s t)
  (define pictures
    (for/list ([p (in-list (scenery-panels s))])
      (define picture ((panel-picture p) t))
      (define trail ((panel-trail-at p) t))
      (lt-superimpose (blank (panel-width p) (panel-height p))
                      (if trail (lt-superimpose trail picture) picture))))
  (apply hc-append gap pictures))

(define gap 10)

;; -> width and height of all pictures, exact integers
(define (scenery-size s)
  (define panels (scenery-panels s))
  (values (exact-ceiling (+ (* gap (- (length panels) 1)) (apply + (map panel-width panels))))
          (exact-ceiling (apply max (map panel-height panels)))))

;; ---------------------------------------------------------------------------
;; The mechanism

(define (mechanism-panel f)
  (define drawing (film-drawing f))
  (define (picture t)
    (define state (film-state f t))
    (check-picture 'animation (drawing state) state))
  (define-values (width height) (largest f picture))
  (define place (if (drawing? drawing) (lambda (p) (drawn-place drawing p)) values))
  (define trails (once (lambda () (trail-curves f place))))
  (panel width height picture trails (lambda (t) (trail->pict f (trails) t width height))))

(define (check-picture who x state)
  (unless (pict? x)
    (complain who "the drawing gives no pict of this state\n  state: ~a\n  given: ~a"
              (value->text state) (describe-with-value x)))
  x)

;; The pictures of a drawing of this library have one size; of other drawings some are measured.
(define sample-size 25)

(define (largest f picture)
  (define s (film-schedule f))
  (define samples
    (for/list ([k (in-range (if (drawing? (film-drawing f)) 1 sample-size))])
      (picture (time-at-share s (/ k (- sample-size 1.0))))))
  (values (apply max 1 (map pict-width samples)) (apply max 1 (map pict-height samples))))

;; ---------------------------------------------------------------------------
;; Trails

(define (detailed s) (+ 1 (* trail-detail (- (schedule-count s) 1))))

(define (detailed-time s k) (time-at-share s (/ k (- (detailed s) 1.0))))

(define (trail-curves f place)
  (define s (film-schedule f))
  (define points
    (if (film-trail f)
        (for/list ([k (in-range (detailed s))])
          (map place ((film-trail f) (film-state f (detailed-time s k)))))
        '()))
  (if (null? points)
      '()
      (for/list ([i (in-range (apply min (map length points)))])
        (for*/flvector #:length (* 2 (length points)) ([all (in-list points)]
                                                       [part (in-vector (list-ref all i))])
          part))))

;; -> the indices of the first and the last visible point of the trails at time t
(define (trail-range f t)
  (define s (film-schedule f))
  (define last (- (detailed s) 1))
  (define (index time)
    (define share (/ (- time (schedule-start s)) (schedule-span s)))
    (max 0 (min last (exact-floor (+ 1e-9 (* last share))))))
  (define back (film-trail-time f))
  (define forward (if (> (schedule-span s) 0.0) 1.0 -1.0))
  (define now (exact->inexact t))
  (values (if back (index (- now (* forward back))) 0) (index now)))

(define (trail->pict f curves t width height)
  (define-values (from to) (trail-range f t))
  (define shapes
    (for/list ([curve (in-list curves)] [color (in-cycle (cdr accents))])
      (define points
        (for*/list ([k (in-range from (+ to 1))]
                    [x (in-value (flvector-ref curve (* 2 k)))]
                    [y (in-value (flvector-ref curve (+ 1 (* 2 k))))]
                    #:when (and (finite? x) (finite? y)))
          (vector x (- y))))
      (if (> (length points) 1) (polyline points #:color color #:width 1.5) '())))
  (and (pair? shapes)
       (paint (list 0.0 width (- height) 0.0) width (flatten shapes))))

;; ---------------------------------------------------------------------------
;; The phase portrait

(define (portrait-panel f)
  (define plane (film-plane f))
  (define s (film-schedule f))
  (define (point t) (plane-point-at plane 'animation (film-state f t)))
  (define p
    (make-portrait (for/list ([k (in-range (detailed s))]) (point (detailed-time s k)))
                   (phase-plane-x-label plane) (phase-plane-y-label plane)))
  (define size (exact->inexact portrait-size))
  (define (picture t)
    (paint (list 0.0 size 0.0 size) size (append (portrait-shapes p) (portrait-dot p (point t)))))
  (panel size size picture (lambda () '()) (lambda (t) #f)))
