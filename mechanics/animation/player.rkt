#lang racket/base
;; A window that plays an animation.
;;
;; It lives in an eventspace of its own, as the windows of frames do: events are handled
;; whatever the prompt or the program is doing.  Where it is, is reckoned from the clock, so
;; that a picture that takes long makes the motion coarse, not slow.

(require racket/class
         racket/gui/base
         racket/math
         (only-in pict draw-pict pict-width pict-height scale))

(provide loaded? open-player)

;; For those who load this module lazily and want to know whether they can.
(define (loaded?) #t)

(define speeds '(0.1 0.25 0.5 1 2 4))
(define usual-speed 3)           ; index
(define slider-steps 1000)

;; picture : share of the whole, from 0 to 1, -> pict; caption : share -> text
;; seconds : how long it takes; pause : milliseconds between pictures
;; closed : -> any, called when the reader closes it
;; -> the window, a frame%
(define (open-player title width height seconds pause picture caption closed)
  (parameterize ([current-eventspace (make-eventspace)])
    (define window
      (new player% [title title] [seconds seconds] [pause pause]
           [picture picture] [caption caption] [closed closed]))
    (send window open width height)
    window))

(define player%
  (class frame%
    (init-field title seconds pause picture caption closed)
    (super-new [label title])
    (define share 0.0)
    (define playing? #f)
    (define then 0.0)                         ; milliseconds

    (define canvas
      (new picture-canvas% [parent this]
           [picture (lambda () (picture share))]
           [failed (lambda (e) (stop) (send status set-label (exn-message e)))]
           [key (lambda (code) (on-key code))]))
    (define row (new horizontal-panel% [parent this] [stretchable-height #f] [spacing 4] [border 4]))
    (define button
      (new button% [parent row] [label "Pause"] [callback (lambda (b e) (toggle))]))
    (define slider
      (new slider% [parent row] [label #f] [min-value 0] [max-value slider-steps]
           [style '(horizontal plain)]
           [callback (lambda (s e) (go-to (/ (send s get-value) slider-steps)))]))
    (define status (new message% [parent row] [label (caption 0.0)] [min-width 90]))
    (define choice
      (new choice% [parent row] [label #f] [choices (map (lambda (s) (format "× ~a" s)) speeds)]
           [selection usual-speed]))
    (define timer (new timer% [notify-callback (lambda () (tick))]))

    (define/public (open width height)
      (send canvas min-client-width width)
      (send canvas min-client-height height)
      (send this show #t)
      (send canvas min-client-width 100)
      (send canvas min-client-height 100)
      (queue-callback (lambda () (start) (show-now))))

    (define/private (start)
      (when (>= share 1.0) (set! share 0.0))
      (set! playing? #t)
      (set! then (current-inexact-milliseconds))
      (send button set-label "Pause")
      (send timer start pause #t))

    (define/private (stop)
      (set! playing? #f)
      (send timer stop)
      (send button set-label "Play"))

    (define/private (toggle) (if playing? (stop) (start)))

    (define/private (go-to new-share)
      (stop)
      (set! share (max 0.0 (min 1.0 (exact->inexact new-share))))
      (show-now))

    ;; After the end it begins anew.
    (define/private (tick)
      (when playing?
        (define now (current-inexact-milliseconds))
        (define speed (list-ref speeds (send choice get-selection)))
        (define next (+ share (/ (* speed (- now then)) 1000.0 seconds)))
        (set! then now)
        (set! share (cond [(<= next 1.0) next] [(< share 1.0) 1.0] [else 0.0]))
        (show-now)
        (when playing?
          (define spent (exact-round (- (current-inexact-milliseconds) now)))
          (send timer start (max 5 (- pause spent)) #t))))

    (define/private (show-now)
      (send status set-label (caption share))
      (send slider set-value (exact-round (* share slider-steps)))
      (send canvas refresh-now))

    (define/private (on-key code)
      (define one (/ pause 1000.0 seconds))
      (case code
        [(#\space) (toggle)]
        [(right) (go-to (+ share one))]
        [(left) (go-to (- share one))]
        [(home) (go-to 0)]
        [(end) (go-to 1)]
        [else (void)]))

    (define/augment (on-close)
      (stop)
      (closed))))

;; Shows a picture as large as there is room.
(define picture-canvas%
  (class canvas%
    (init-field picture failed key)
    (super-new)
    (inherit get-dc get-client-size)
    (define/override (on-paint)
      (define dc (get-dc))
      (with-handlers ([exn:fail? failed])
        (define p (picture))
        (define-values (width height) (get-client-size))
        (define factor (min (/ width (pict-width p)) (/ height (pict-height p))))
        (define shown (scale p factor))
        (send dc set-smoothing 'smoothed)
        (draw-pict shown dc (/ (- width (pict-width shown)) 2) (/ (- height (pict-height shown)) 2))))
    (define/override (on-char event) (key (send event get-key-code)))))
