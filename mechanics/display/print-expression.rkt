#lang racket/base
;; Printing values on demand, simplified: what the prompt does to results.

(require "layout.rkt" "result.rkt" "text.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../value/series/access.rkt"
         "../verdict/verdict.rkt")

(provide print-expression pe show-expression se series:print print-as
         print-labelled print-assumptions)

(require-on-demand ["typeset.rkt" typeset-result])

(define line-width 79)

;; The value, simplified, on lines of its own: as the prompt has it, or typeset in a format.
(define-plain (print-expression x #:as [format #f])
  (print-as 'print-expression x format))

(define (print-as who x format)
  (if format
      (write-string (typeset-result who x format))
      (print (simplified-result x line-width)))
  (newline))

(define pe print-expression)

;; Shows a value the best way the place it is called from allows: as text.
(define-plain (show-expression x #:as [format #f]) (print-as 'show-expression x format))
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
