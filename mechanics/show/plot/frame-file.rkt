#lang racket/base
;; The picture of a frame as a file.

(require "frame.rkt" "on-demand.rkt" "picture-file.rkt"
         "../../generic/define-plain.rkt")

(provide graphics-save)

;; extension -> format
(define formats
  '((#".png" . png-bytes) (#".svg" . svg-bytes) (#".pdf" . pdf-bytes)))

(define-plain (graphics-save f file)
  (check-frame 'graphics-save f)
  (define format (format-of-file 'graphics-save file formats ".png, .svg or .pdf"))
  (check-file 'graphics-save file why-not)
  (define bytes (frame->bytes f format))
  (write-file 'graphics-save file bytes))
