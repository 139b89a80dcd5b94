#lang racket/base
;; A window that plays an animation.
;;
;; It lives in an eventspace of its own, as the windows of frames do: events are handled
;; whatever the prompt or the program is doing.  Where it is, is reckoned from the clock, so
;; that a picture that takes long makes the motion coarse, not slow.

(require racket/class
         racket/gui/base
         racket/math
         (only-in pict draw-pict pict-width pict-height scale)
         "../plot/window.rkt")

(provide loaded? open-player make-performance)

;; The animation that is played.  picture : share of the whole, from 0 to 1, -> pict
;; caption : share -> text; seconds : duration; pause : milliseconds between pictures
(struct performance (title width height seconds pause picture caption)
  #:constructor-name make-performance)

;; share : of the whole that has been played; then : the clock at that share, in milliseconds
(struct player (performance canvas controls timer
                [share #:mutable] [playing? #:mutable] [then #:mutable]))
(struct controls (button slider status choice))

(define speeds '(0.1 0.25 0.5 1 2 4))
(define usual-speed 3)           ; index
(define slider-steps 1000)

;; closed : -> any, called when the reader closes it
;; -> the window, a frame%
(define (open-player work closed)
  (parameterize ([current-eventspace (make-eventspace)])
    (define window
      (titled-window (performance-title work) (lambda ()
                                                (stop! it)
                                                (closed))))
    (define canvas
      (new picture-canvas% [parent window]
           [picture (lambda () ((performance-picture work) (player-share it)))]
           [failed (lambda (e) (fail! it e))]
           [key (lambda (code) (on-key it code))]))
    (define it
      (player work canvas
              (make-controls window work
                             (lambda () (toggle! it))
                             (lambda (share) (go-to! it share)))
              (new timer% [notify-callback (lambda () (tick! it))])
              0.0 #f 0.0))
    (show-at-size window canvas (performance-width work) (performance-height work))
    (queue-callback (lambda () (start! it) (show-now it)))
    window))

(define (make-controls window work toggle go)
  (define row
    (new horizontal-panel% [parent window] [stretchable-height #f] [spacing 4] [border 4]))
  (controls
   (new button% [parent row] [label "Pause"] [callback (lambda (b e) (toggle))])
   (new slider% [parent row] [label #f] [min-value 0] [max-value slider-steps]
        [style '(horizontal plain)]
        [callback (lambda (s e) (go (/ (send s get-value) slider-steps)))])
   (new message% [parent row] [label ((performance-caption work) 0.0)] [min-width 90])
   (new choice% [parent row] [label #f]
        [choices (for/list ([s (in-list speeds)]) (format "× ~a" s))]
        [selection usual-speed])))

;; ---------------------------------------------------------------------------
;; Playing

(define (start! p)
  (when (>= (player-share p) 1.0) (set-player-share! p 0.0))
  (set-player-playing?! p #t)
  (set-player-then! p (current-inexact-milliseconds))
  (send (controls-button (player-controls p)) set-label "Pause")
  (send (player-timer p) start (performance-pause (player-performance p)) #t))

(define (stop! p)
  (set-player-playing?! p #f)
  (send (player-timer p) stop)
  (send (controls-button (player-controls p)) set-label "Play"))

(define (toggle! p) (if (player-playing? p) (stop! p) (start! p)))

(define (go-to! p share)
  (stop! p)
  (set-player-share! p (max 0.0 (min 1.0 (exact->inexact share))))
  (show-now p))

;; Advances to the share that the clock says; after the end it begins anew.
(define (tick! p)
  (when (player-playing? p)
    (define work (player-performance p))
    (define now (current-inexact-milliseconds))
    (define speed (list-ref speeds (send (controls-choice (player-controls p)) get-selection)))
    (define share (player-share p))
    (define next
      (+ share (/ (* speed (- now (player-then p))) 1000.0 (performance-seconds work))))
    (set-player-then! p now)
    (set-player-share! p (cond [(<= next 1.0) next] [(< share 1.0) 1.0] [else 0.0]))
    (show-now p)
    (when (player-playing? p)
      (define spent (exact-round (- (current-inexact-milliseconds) now)))
      (send (player-timer p) start (max 5 (- (performance-pause work) spent)) #t))))

(define (show-now p)
  (define c (player-controls p))
  (define share (player-share p))
  (send (controls-status c) set-label ((performance-caption (player-performance p)) share))
  (send (controls-slider c) set-value (exact-round (* share slider-steps)))
  (send (player-canvas p) refresh-now))

;; A picture could not be made: the motion stops there, and the window says why.
(define (fail! p e)
  (stop! p)
  (send (controls-status (player-controls p)) set-label (exn-message e)))

(define (on-key p code)
  (define work (player-performance p))
  (define one (/ (performance-pause work) 1000.0 (performance-seconds work)))
  (case code
    [(#\space) (toggle! p)]
    [(right) (go-to! p (+ (player-share p) one))]
    [(left) (go-to! p (- (player-share p) one))]
    [(home) (go-to! p 0)]
    [(end) (go-to! p 1)]
    [else (void)]))

;; ---------------------------------------------------------------------------

;; Shows a picture as large as there is room.
(define picture-canvas%
  (class canvas%
    (init-field picture failed key)
    (super-new)
    (inherit get-dc get-client-size)
    (define/override (on-paint)
      (with-handlers ([exn:fail? failed])
        (define-values (width height) (get-client-size))
        (draw-centered (picture) (get-dc) width height)))
    (define/override (on-char event) (key (send event get-key-code)))))

(define (draw-centered p dc width height)
  (define shown (scale p (min (/ width (pict-width p)) (/ height (pict-height p)))))
  (send dc set-smoothing 'smoothed)
  (draw-pict shown dc
             (/ (- width (pict-width shown)) 2) (/ (- height (pict-height shown)) 2)))
