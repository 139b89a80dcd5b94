#lang racket/base
;; A window that shows a picture while it is being drawn.
;;
;; The window looks for changes by itself, from time to time, so that drawing does not
;; wait for it; the longer a picture takes, the longer it waits before the next.  It
;; lives in an eventspace of its own: events are handled whatever the prompt or the
;; program is doing, and the program may end without it.

(require racket/class
         racket/gui/base
         (only-in pict draw-pict))

(provide loaded? open-window wait-until
         ;; for other windows
         titled-window show-at-size)

;; A call of it loads this module: so a caller learns whether that is possible.
(define (loaded?) #t)

(define least-pause 40)          ; milliseconds between two looks

;; version : -> number, of changes; picture : width height -> pict, of that size
;; closed : -> any, called when the window is closed
;; -> the window: a procedure that closes it, and an event, that it is closed
(define (open-window title width height version picture closed)
  (define space (make-eventspace))
  (define over (make-semaphore))
  (define (finish)
    (semaphore-post over)
    (closed))
  (parameterize ([current-eventspace space])
    (define window
      (titled-window title (lambda ()
                             (send timer stop)
                             (finish))))
    (define canvas (new picture-canvas% [parent window] [picture picture]))
    (define shown #f)
    (define (look)
      (define now (version))
      (define pause (if (equal? now shown) least-pause (send canvas renew)))
      (set! shown now)
      (send timer start pause #t))
    (define timer (new timer% [notify-callback look]))
    (show-at-size window canvas width height)
    (queue-callback look)
    (define (close)
      (finish)
      (parameterize ([current-eventspace space])
        (queue-callback
         (lambda ()
           (send timer stop)
           (send window show #f)))))
    (picture-window close (semaphore-peek-evt over))))

(struct picture-window (close closed)
  #:property prop:procedure (struct-field-index close)
  #:property prop:evt (struct-field-index closed))

;; closed : -> any, called when the reader closes the window
(define (titled-window title closed)
  (new (class frame%
         (super-new [label title])
         (define/augment (on-close) (closed)))))

;; The window opens at this size; the reader may change it.
(define (show-at-size window canvas width height)
  (send canvas min-client-width width)
  (send canvas min-client-height height)
  (send window show #t)
  (send canvas min-client-width 100)
  (send canvas min-client-height 100))

;; Waits for an event, in the thread that handles those of an eventspace as well.
(define (wait-until closed) (void (yield closed)))

(define picture-canvas%
  (class canvas%
    (init-field picture)
    (inherit get-client-size refresh-now get-dc)
    (define bitmap #f)
    (super-new)

    ;; -> milliseconds to wait before the next
    (define/public (renew)
      (define start (current-inexact-milliseconds))
      (define-values (width height) (get-client-size))
      (set! bitmap (render (max 50 width) (max 50 height)))
      (refresh-now)
      (max least-pause
           (inexact->exact (round (* 4 (- (current-inexact-milliseconds) start))))))

    (define (render width height)
      (define target (make-screen-bitmap width height))
      (define dc (new bitmap-dc% [bitmap target]))
      (draw-pict (picture width height) dc 0 0)
      target)

    (define/override (on-paint)
      (when bitmap (send (get-dc) draw-bitmap bitmap 0 0)))

    (define/override (on-size width height)
      (when bitmap (renew)))))
