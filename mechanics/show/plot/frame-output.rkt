#lang racket/base
;; Frames shown: as picts, in files, and on the screen, where there is one.
;;
;; A pict and a file hold the picture as it is now, which later drawing does not change; a window
;; follows later drawing.

(require "frame.rkt" "on-demand.rkt" "../../generic/output-file.rkt"
         "../display/drawing-library.rkt"
         "../../generic/define-plain.rkt")

(provide frame->pict graphics-save graphics-show)

(define-plain (frame->pict f)
  (check-frame 'frame->pict f)
  (check-drawing 'frame->pict why-not)
  (make-picture (frame-view f) (frame-now (seen f))))

;; extension -> format
(define formats
  '((#".png" . png-bytes) (#".svg" . svg-bytes) (#".pdf" . pdf-bytes)))

(define-plain (graphics-save f file)
  (check-frame 'graphics-save f)
  (define format (format-of-file 'graphics-save file formats ".png, .svg or .pdf"))
  (check-file 'graphics-save file why-not)
  (define bytes (frame->bytes f format))
  (write-file 'graphics-save file bytes))

;; Opens a window at once.  wait? : until it is closed; 'at-end : at the end of the program
(define-plain (graphics-show f #:wait? [wait? 'at-end])
  (check-open 'graphics-show f)
  (show-frame f wait?))
