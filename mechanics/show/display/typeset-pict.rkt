#lang racket/base
;; Values as picts of formulas.

(require "../typesetting/break.rkt" "../typesetting/formula-pict.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/value-tree.rkt"
         (only-in "typeset.rkt" check-width))

(provide ->pict loaded?)

;; size : of the letters; color : a color's name or object, #f for that of the text around
(define-plain (->pict x #:size [size 16] #:width [width 80] #:color [color #f])
  (check-width '->pict width)
  (unless (and (real? size) (< 0 size 1000))
    (complain '->pict "expected a size of letters, a number between 0 and 1000\n  given: ~e" size))
  (tree->pict (fit (value->tree x #t) width) size color))

;; To call it loads this file, and what it stands on.
(define (loaded?) #t)
