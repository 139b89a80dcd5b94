#lang racket/base
;; The tree of a formula as text, in each of the formats.

(require "../typesetting/MathML.rkt" "../typesetting/TeX.rkt" "../typesetting/break.rkt"
         "../typesetting/drawn-text.rkt"
         "../../algebra/notation/infix.rkt")

(provide tree-in-format)

;; format : 'infix, which is one line, 'text, 'TeX or 'MathML
(define (tree-in-format tree width format)
  (case format
    [(infix) (tree->line tree)]
    [(text) (tree->text (fit tree width))]
    [(TeX) (tree->TeX (fit tree width))]
    [else (tree->MathML (fit tree width) #t)]))
