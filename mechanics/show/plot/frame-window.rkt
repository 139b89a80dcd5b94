#lang racket/base
;; Frames on the screen, where there is one.  The window and the libraries for it are
;; loaded when the first is opened.

(require "frame.rkt" "frame-pict.rkt" "window-screen.rkt" "view.rkt"
         "../../generic/define-plain.rkt" "../../generic/on-demand.rkt")

(require-on-demand #:in-this-thread ["window.rkt" loaded? open-window])

(provide graphics-show)

;; Opens a window at once; it follows later drawing.
(define-plain (graphics-show f)
  (check-open 'graphics-show f)
  (unless (frame-on-close f)
    (check-screen 'graphics-show loaded? "(graphics-save frame \"picture.png\")")
    (define v (frame-view f))
    (set-frame-on-close!
     f
     (open-window (or (view-title v) "mechanics")
                  (view-width v) (view-height v)
                  (lambda () (frame-version f))
                  (lambda (width height) (frame->pict/size f width height))
                  (lambda () (set-frame-on-close! f #f))))))
