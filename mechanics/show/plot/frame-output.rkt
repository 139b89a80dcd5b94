#lang racket/base
;; Frames shown: as picts, in files, and on the screen, where there is one.
;;
;; A pict and a file hold the picture as it is now, which later drawing does not change; a window
;; follows later drawing.  The window and the libraries for it are loaded when the first is opened.

(require "frame.rkt" "on-demand.rkt" "picture-file.rkt" "view.rkt" "window-screen.rkt"
         "../display/drawing-library.rkt"
         "../../generic/define-plain.rkt" "../../generic/on-demand.rkt")

(require-on-demand #:in-this-thread ["window.rkt" loaded? open-window])

(provide frame->pict graphics-save graphics-show)

(define-plain (frame->pict f)
  (check-frame 'frame->pict f)
  (check-drawing 'frame->pict why-not)
  (make-picture (frame-view f) (frame-now f)))

;; extension -> format
(define formats
  '((#".png" . png-bytes) (#".svg" . svg-bytes) (#".pdf" . pdf-bytes)))

(define-plain (graphics-save f file)
  (check-frame 'graphics-save f)
  (define format (format-of-file 'graphics-save file formats ".png, .svg or .pdf"))
  (check-file 'graphics-save file why-not)
  (define bytes (frame->bytes f format))
  (write-file 'graphics-save file bytes))

;; Opens a window at once.
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
                  (lambda (width height)
                    (make-picture (struct-copy view v [width width] [height height])
                                  (frame-now f)))
                  (lambda () (set-frame-on-close! f #f))))))
