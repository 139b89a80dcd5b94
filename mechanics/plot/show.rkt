#lang racket/base
;; Frames on the screen, where there is one.  The window and the libraries for it are
;; loaded when the first is opened.

(require "frame.rkt" "frame-pict.rkt" "view.rkt"
         "../error/machine.rkt"
         "../generic/on-demand.rkt")

(require-on-demand #:in-this-thread ["window.rkt" loaded? open-window])

(provide graphics-show)

;; At once; the window follows what is drawn from then on.
(define (graphics-show f)
  (check-open 'graphics-show f)
  (unless (frame-on-close f)
    (check-screen)
    (define v (frame-view f))
    (set-frame-on-close!
     f
     (open-window (or (view-title v) "mechanics")
                  (view-width v) (view-height v)
                  (lambda () (frame-version f))
                  (lambda (width height) (frame->pict/size f width height))
                  (lambda () (set-frame-on-close! f #f))))))

;; Racket's library of windows asks for the screen when it is loaded.
(define (check-screen)
  (with-handlers ([exn:fail? raise-no-screen]) (loaded?)))

(define (raise-no-screen e)
  (raise-unavailable
   'graphics-show "no window can be opened here\n  reason: ~a\n  ~a\n  ~a"
   (exn-message e)
   "to a file it goes with (graphics-save frame \"picture.png\")"
   "windows need a display and the library GTK 3: on Debian and Ubuntu, apt install libgtk-3-0"))
