#lang racket/base
;; Formulas as labels in pictures, typeset.

(require (only-in pict draw-pict pict-height pict-width rotate)
         "../../typesetting/formula-pict.rkt")

(provide label-measures draw-label)

;; tree : of a formula; size : of letters, in units -> width, height
(define (label-measures tree size)
  (define p (tree->pict tree size #f))
  (values (pict-width p) (pict-height p)))

;; x, y : the upper left corner; turned? : is it read from below upwards?
(define (draw-label dc tree size x y turned?)
  (define p (tree->pict tree size #f))
  (draw-pict (if turned? (rotate p (/ (acos -1) 2)) p) dc x y))
