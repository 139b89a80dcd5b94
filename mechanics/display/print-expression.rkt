#lang racket/base
;; Printing values on demand, simplified: what the prompt does to results.

(require "layout.rkt" "result.rkt" "text.rkt"
         "../generic/describe.rkt"
         "../value/series/access.rkt"
         "../verdict/verdict.rkt")

(provide print-expression pe show-expression se series:print print-labelled print-assumptions)

(define line-width 79)

;; The value, simplified, in the book's form, on lines of its own.
(define (print-expression x)
  (print (simplified-result x line-width))
  (newline))

(define pe print-expression)

;; Shows a value the best way the place it is called from allows: as text.
(define (show-expression x) (print-expression x))
(define se show-expression)

;; The first n terms of a series, all where it ends, each as print-expression has it.
(define (series:print s [n #f])
  (for-each-term 'series:print "(series:print s n)" print-expression s n))

;; A label, and below it, indented, a value as it stands.
(define (print-labelled label x)
  (write-string (layout label line-width))
  (write-string "\n  ")
  (write-string (if (verdict? x)
                    (regexp-replace* #rx"\n" (value->lines x (- line-width 2)) "\n  ")
                    (layout (value->datum x) line-width 2)))
  (newline))

;; What simplification took for granted and what it left unexpanded, a line each.
(define (print-assumptions notes)
  (for ([n (in-list notes)])
    (write-string (note->text n))
    (newline)))
