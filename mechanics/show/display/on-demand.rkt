#lang racket/base
;; Typeset formulas, loaded when the first one is asked for.

(require "result.rkt"
         "../../generic/on-demand.rkt")

(provide-on-demand ["typeset.rkt" ->infix ->text ->TeX ->MathML read-infix])
(provide typeset)

;; The value, simplified, to be shown as a picture by a program that shows values convertible to
;; one: a notebook, a page of Scribble.
(define (typeset x) (simplified-result x 79 'picture))
