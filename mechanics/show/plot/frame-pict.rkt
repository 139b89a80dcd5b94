#lang racket/base
;; A picture as a pict, and in the formats that only picts have.

(require file/convertible
         (only-in pict unsafe-dc)
         "picture.rkt" "view.rkt")

(provide make-picture converted-picture)

;; The canvas is left as it was, of which `dc` would make sure by drawing twice.
(define (make-picture v layers)
  (unsafe-dc (lambda (canvas x y) (draw-picture canvas v layers x y))
             (view-width v) (view-height v)))

;; format : as `convert` names it
(define (converted-picture v layers format default)
  (convert (make-picture v layers) format default))
