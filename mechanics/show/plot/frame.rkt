#lang racket/base
;; Frames: windows of the plane that hold the points and curves drawn in them (SICM 1.4, p. 23).
;;
;; Drawing only records; a picture is made when one is asked for, as where a frame is
;; printed in DrRacket.  So a monitor may draw ten thousand points without a delay, on
;; a machine without a display.  Whoever changes a frame holds its lock, and breaks wait
;; until the change is complete; user's code is never called meanwhile.
;;
;; A frame on a page of Scribble is serialized where it is printed, hence shown as it
;; was then.

(require file/convertible
         racket/serialize
         "picture-layer.rkt" "on-demand.rkt" "points.rkt" "view.rkt" "window-screen.rkt"
         "../../error/complain.rkt"
         "../display/picture-advice.rkt" "../display/program-end.rkt"
         "../../generic/define-plain.rkt" "../../generic/on-demand.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt")

(require-on-demand #:in-this-thread ["window.rkt" loaded? open-window wait-until])

(provide
 frame frame?
 frame-points frame-curves
 graphics-clear graphics-close
 ;; for drawing
 check-frame check-open check-plain frame-bounds add-dot! add-line! add-layer!
 frame-layers replace-layers!
 ;; for showing
 frame-view frame-now frame->bytes show-frame seen
 ;; for tests
 frame-window)

;; layers : latest first; version : number of changes; window : of window.rkt, or #f
(value-struct frame (view lock [layers #:mutable] [closed? #:mutable]
                          [version #:mutable] [window #:mutable])
  #:text frame->text
  #:constructor-name new-frame
  #:omit-define-syntaxes
  #:property prop:advice
  (lambda (f) (string-append "to see a frame f: (graphics-show f), or " how-to-save))
  #:property prop:convertible
  (lambda (f request default)
    (cond [(eq? request 'text) (frame->text f)]
          [(not (can-draw?)) default]
          [(eq? request 'picture-for-later) (present-picture f)]
          [else (frame->bytes f request default)]))
  #:property prop:serializable
  (make-serialize-info (lambda (f) (stored-frame (seen f))) #'frame-deserialize-info #f
                       (or (current-load-relative-directory) (current-directory))))

(define-plain (frame x-min x-max y-min y-max
                     #:title [title #f] #:x-label [x-label #f] #:y-label [y-label #f]
                     #:width [width 400] #:height [height 400]
                     #:aspect-ratio [aspect-ratio #f]
                     #:x-scale [x-scale 'linear] #:y-scale [y-scale 'linear])
  (new-frame (make-view (list x-min x-max y-min y-max) title x-label y-label
                        width height aspect-ratio (list x-scale y-scale))
             (make-semaphore 1) '() #f 0 #f))

(define (check-frame who f)
  (check-argument who frame? f "a frame, such as (frame 0 1 -1 1)"))

;; Complains of a closed frame, before anything is computed for it.
(define (check-open who f)
  (check-frame who f)
  (when (frame-closed? f) (raise-closed who f)))

;; Complains of a frame with logarithmic axes, for drawings on plain ones alone.
(define (check-plain who f)
  (check-open who f)
  (unless (plain-axes? (frame-view f))
    (complain who "this is drawn on plain axes; the frame has logarithmic ones\n  frame: ~a"
              (frame->text f))))

(define (raise-closed who f)
  (complain-showing who "the frame is closed; make a new one to draw in" "frame" f))

(define (frame-bounds f) (view-bounds (frame-view f)))

;; ---------------------------------------------------------------------------
;; Changes

(define-syntax-rule (change! who f body ...)
  (begin
    (check-frame who f)
    (unless (parameterize-break #f
              (call-with-semaphore
               (frame-lock f)
               (lambda ()
                 (cond [(frame-closed? f) #f]
                       [else
                        body ...
                        (set-frame-version! f (+ 1 (frame-version f)))
                        #t]))))
      (raise-closed who f))
    (define watch (current-picture-watcher))
    (when watch (watch f))
    (when (and (eqv? 1 (frame-version f)) (not (frame-window f)))
      (note-unseen! f (lambda () (show-frame f 'at-end)) (lambda () (unseen-remark f))))))

(define-plain (graphics-clear f)
  (change! 'graphics-clear f (set-frame-layers! f '())))

;; The picture stays; nothing more can be drawn.
(define-plain (graphics-close f)
  (check-frame 'graphics-close f)
  (set-frame-closed?! f #t)
  (define close (frame-window f))
  (when close (close)))

(define (add-layer! who f style data)
  (change! who f (set-frame-layers! f (cons (layer style data) (frame-layers f)))))

;; layers : as frame-layers gives them, the latest first
(define (replace-layers! who f layers)
  (change! who f (set-frame-layers! f layers)))

;; Points of one style are one layer, and so are lines.  Points outside the frame are dropped.
(define (add-dot! who f style x y)
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  (change! who f
           (define points (layer-points! f style))
           (when (and (<= x-min x x-max) (<= y-min y y-max))
             (add-point! points x y))))

(define (add-line! who f style x1 y1 x2 y2)
  (change! who f
           (define points (layer-points! f style))
           (add-point! points x1 y1)
           (add-point! points x2 y2)
           (add-point! points +nan.0 +nan.0)))

(define (layer-points! f style)
  (define layers (frame-layers f))
  (define found (findf (lambda (l) (equal? style (layer-style l))) layers))
  (define l (or found (layer style (make-points))))
  (unless found (set-frame-layers! f (cons l layers)))
  (layer-data l))

;; ---------------------------------------------------------------------------
;; The present picture

;; -> the layers, the lowest first; later drawing does not change them.  No lock is needed.
(define (frame-now f) (layers-now (reverse (frame-layers f))))

(define-plain (frame-points f)
  (check-frame 'frame-points f)
  (for*/list ([l (in-list (frame-now (seen f)))] #:when (eq? (layer-kind l) 'points)
              [v (in-list (snapshot->vectors (layer-data l)))])
    v))

(define-plain (frame-curves f)
  (check-frame 'frame-curves f)
  (for*/list ([l (in-list (frame-now (seen f)))] #:when (memq (layer-kind l) '(curve lines))
              [c (in-list (snapshot->curves (layer-data l)))])
    c))

(define (frame->text f)
  (define-values (x-min x-max y-min y-max) (apply values (frame-bounds f)))
  (format "(frame x from ~a to ~a, y from ~a to ~a: ~a)"
          x-min x-max y-min y-max (layers->text (frame-now f))))

(define (frame->bytes f format [default #f]) ((present-picture f) format default))

;; -> a procedure: a format -> bytes, of the frame as it is now
(define (present-picture f)
  (define-values (v layers) (values (frame-view f) (frame-now (seen f))))
  (lambda (format [default #f]) (picture-bytes v layers format default)))

;; ---------------------------------------------------------------------------
;; Frames to show at the end of the program (display/program-end.rkt)

(define how-to-save "(graphics-save f \"picture.png\")")

(define (unseen-remark f)
  (define title (view-title (frame-view f)))
  (format "never shown: ~a~a; ~a writes it to a file"
          (frame->text f) (if title (format ", ~s" title) "") how-to-save))

;; -> f, of which somebody has the picture or the numbers
(define (seen f)
  (note-seen! f)
  f)

;; ---------------------------------------------------------------------------
;; On the screen

;; Opens a window, unless there is one.
(define (show-frame f wait?)
  (unless (frame-window f)
    (check-screen 'graphics-show loaded? "(graphics-save frame \"picture.png\")")
    (define v (frame-view (seen f)))
    (set-frame-window!
     f
     (open-window (or (view-title v) "mechanics")
                  (view-width v) (view-height v)
                  (lambda () (frame-version f))
                  (lambda (width height)
                    (make-picture (struct-copy view v [width width] [height height])
                                  (frame-now f)))
                  (lambda () (set-frame-window! f #f)))))
  (define window (frame-window f))
  (when window (stay-open! wait? window wait-until)))

;; ---------------------------------------------------------------------------
;; Frames in files

(define (stored-frame f)
  (vector (frame-view f) (frame-closed? f) (map stored-layer (frame-now f))))

(define (restored-frame view closed? layers)
  (new-frame view (make-semaphore 1) (reverse (map restored-layer layers)) closed? 0 #f))

(define frame-deserialize-info
  (make-deserialize-info restored-frame
                         (lambda () (values (frame 0 1 0 1) void))))  ; never in a cycle

(module+ deserialize-info
  (provide frame-deserialize-info))
