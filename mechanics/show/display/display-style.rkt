#lang racket/base
;; How results are shown: the style that the reader chose, and the form it takes on this output.
;;
;; Nothing is asked of a terminal.  A port that takes pictures belongs to an editor of
;; Racket's, as DrRacket's do, or to something else that will show values convertible to a
;; picture, such as a page of Scribble that is being made.

(require "../../error/complain.rkt"
         "../../generic/on-demand.rkt"
         (only-in racket/string string-join))

(require-on-demand [racket/gui/dynamic gui-available?])

(provide display-style styles check-style manner-here)

;; 'automatic: typeset where pictures are shown, S-expressions elsewhere.
(define styles '(automatic typeset text infix TeX MathML expression))

(define display-style
  (make-parameter 'automatic (lambda (style) (check-style 'display-style style) style)
                  'display-style))

(define (check-style who style)
  (unless (memq style styles)
    (complain who "there is no such style\n  styles: ~a\n  given: ~e"
              (string-join (for/list ([s (in-list styles)]) (format "'~a" s)) ", ")
              style)))

;; The form for the present output: a 'snip, a 'picture, 'text, 'infix, 'TeX,
;; 'MathML or an 'expression.
(define (manner-here [style (display-style)])
  (case style
    [(automatic) (or (picture-here) 'expression)]
    [(typeset) (or (picture-here) 'text)]
    [else style]))

;; -> 'snip, 'picture or #f.  Racket's library of windows is not loaded for the answer.
(define (picture-here)
  (cond [(not (port-writes-special? (current-output-port))) #f]
        [(gui-available?) 'snip]
        [else 'picture]))
