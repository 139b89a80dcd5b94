#lang racket/base
;; Values as picts of formulas.

(require (only-in "typeset.rkt" fitted-tree)
         "../typesetting/formula-pict.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt")

(provide ->pict loaded?)

;; size : of the letters; color : a color's name or object, #f for that of the text around
(define-plain (->pict x #:size [size 16] #:width [width 80] #:color [color #f])
  (define tree (fitted-tree '->pict x width))
  (unless (and (real? size) (< 0 size 1000))
    (complain '->pict "expected a size of letters, a number between 0 and 1000\n  given: ~e" size))
  (tree->pict tree size color))

;; To call it loads this file, and those it requires.
(define (loaded?) #t)
