#lang racket/base
;; Frames on the screen, where there is one.  The window and the libraries for it are
;; loaded when the first is opened.

(require racket/lazy-require
         "frame.rkt" "pict.rkt" "view.rkt")

(lazy-require ["window.rkt" (open-window)])

(provide graphics-show)

;; At once; the window follows what is drawn from then on.
(define (graphics-show f)
  (check-open 'graphics-show f)
  (unless (frame-on-close f)
    (define v (frame-view f))
    (set-frame-on-close!
     f
     (with-handlers ([exn:fail? (lambda (e) (raise-no-screen e))])
       (open-window (or (view-title v) "mechanics")
                    (view-width v) (view-height v)
                    (lambda () (frame-version f))
                    (lambda (width height) (frame->pict/size f width height))
                    (lambda () (set-frame-on-close! f #f)))))))

(define (raise-no-screen e)
  (raise
   (exn:fail
    (format "graphics-show: no window can be opened here\n  reason: ~a\n  ~a"
            (exn-message e)
            "to a file it goes with (graphics-save frame \"picture.png\")")
    (current-continuation-marks))))
