#lang racket/base
;; Printing values on demand, simplified: what the prompt does to results.

(require "layout.rkt" "text.rkt"
         "../generic/describe.rkt" "../value/simplify.rkt")

(provide print-expression pe show-expression se print-labelled)

(define line-width 79)

;; The value, simplified, in the book's form, on lines of its own.
(define (print-expression x)
  (define-values (simplified assumptions) (simplify/assumptions x))
  (write-string (value->lines simplified line-width assumptions))
  (newline))

(define pe print-expression)

;; Shows a value the best way the place it is called from allows: as text.
(define (show-expression x) (print-expression x))
(define se show-expression)

;; A label, and below it, indented, a value as it stands.
(define (print-labelled label x)
  (write-string (layout label line-width))
  (write-string "\n  ")
  (write-string (layout (value->datum x) (- line-width 2)))
  (newline))
