#lang racket/base
;; Values as formulas: the tree of a value, drawn in one of several ways.

(require "../typesetting/MathML.rkt" "../typesetting/TeX.rkt" "../typesetting/break.rkt"
         "../typesetting/drawn-text.rkt"
         "../../algebra/notation/infix.rkt" "../../algebra/notation/read-infix.rkt"
         "../../error/note.rkt"
         "../../generic/define-plain.rkt" "../../generic/value-tree.rkt"
         "../../generic/wrong-argument.rkt"
         "../../value/read-expression.rkt")

(provide ->infix ->text ->TeX ->MathML read-infix fitted-tree)

;; On one line, in characters of Unicode.
(define (->infix x) (tree->line (value->tree x #f)))

;; In lines of text, fractions and roots drawn.
(define-plain (->text x #:width [width 80])
  (tree->text (fitted-tree '->text x width)))

;; For LaTeX's mathematics mode, with amsmath.
(define-plain (->TeX x #:width [width 80])
  (tree->TeX (fitted-tree '->TeX x width)))

(define-plain (->MathML x #:width [width 80] #:inline? [inline? #f])
  (tree->MathML (fitted-tree '->MathML x width) (not inline?)))

;; The tree of x, cut into lines of a width that is checked.
(define (fitted-tree who x width)
  (unless (or (not width) (exact-positive-integer? width))
    (complain-of-argument who "a width in columns, or #f for lines of any length" width))
  (fit (value->tree x #t) width))

;; The value of a formula that is written as ->infix writes it.
(define (read-infix text)
  (check-argument 'read-infix string? text "a string such as \"½ m ẋ²\"")
  (when (regexp-match? #px"\\p{L}\\^[0-9]" text) (note-superscript))
  (read-expression (infix->datum text)))

;; x^2 is also the name of a component of a literal tuple.
(define (note-superscript)
  (note-once "read-infix: x^2 is a name with a superscript; the square of x is x² or x**2"))
