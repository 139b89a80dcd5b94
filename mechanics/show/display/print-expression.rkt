#lang racket/base
;; Printing values on demand, simplified, as the prompt prints results.

(require "display-style.rkt" "layout.rkt" "print-shown.rkt" "result-note.rkt"
         "receiving-printer.rkt" "result.rkt" "result-lines.rkt"
         (only-in "../../error/hint.rkt" quoted-expression?)
         (only-in "../../error/note.rkt" note-once)
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../value/series/series-access.rkt"
         "../../verdict/verdict.rkt")

(provide print-expression show-expression series:print print-as
         print-labelled print-assumptions)

(define line-width 79)

;; The value, simplified, on lines of its own: in the style that was chosen, or in another.
(define-plain (print-expression x #:as [style #f]) (print-as 'print-expression x style))

;; Typeset in the way that the place it is called from allows, or in another style.
(define-plain (show-expression x #:as [style #f])
  (print-as 'show-expression x (or style 'typeset)))

;; style : one of those of display-style, or #f for the one that was chosen
(define (print-as who x style)
  (when style (check-style who style))
  (when (quoted-expression? x)
    (note-once "a quoted list is no expression; read-expression makes one of it"))
  (define receiver (and (memq (or style (display-style)) '(automatic typeset)) (receiver-here)))
  (if receiver
      (receiver x)
      (print-text x (if style (manner-here style) (manner-here)))))

(define (print-text x manner)
  (print-shown (simplified-result x line-width manner)
               (lambda (shown)
                 ((if (port-writes-special? (current-output-port)) write print) shown)
                 (newline))))

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

;; The notes of a simplification, assumptions and parts left unexpanded, a line each.
(define (print-assumptions notes)
  (for ([n (in-list notes)])
    (write-string (note->text n))
    (newline)))
