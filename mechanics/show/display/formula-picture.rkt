#lang racket/base
;; Formulas for places that show what can be converted to a picture: pages of Scribble,
;; notebooks.

(require file/convertible
         "result-formula.rkt"
         "../../generic/on-demand.rkt"
         (only-in "../../generic/value-struct.rkt" value-struct))

(require-on-demand ["formula-drawing.rkt" convert-formula])

(provide formula->picture)

;; It prints as the text that it is elsewhere, and stays text where the libraries that draw
;; are missing.
(value-struct picture (formula)
  #:text (lambda (p) (formula-text (picture-formula p)))
  #:property prop:convertible
  (lambda (p request default)
    (with-handlers ([exn:fail? (lambda (e) default)])
      (convert-formula (picture-formula p) request default))))

(define (formula->picture f) (picture f))
