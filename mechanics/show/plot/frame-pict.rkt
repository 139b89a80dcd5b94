#lang racket/base
;; Frames as picts: their picture now, which later drawing does not change.

(require "frame.rkt" "on-demand.rkt" "view.rkt"
         "../display/drawing-library.rkt"
         "../../generic/define-plain.rkt")

(provide frame->pict frame->pict/size)

(define-plain (frame->pict f)
  (check-frame 'frame->pict f)
  (check-drawing 'frame->pict why-not)
  (make-picture (frame-view f) (frame-now f)))

;; For a window that has another size.
(define (frame->pict/size f width height)
  (make-picture (struct-copy view (frame-view f) [width width] [height height]) (frame-now f)))
