#lang racket/base
;; What is told beneath a result: what its simplification took for granted, and what it left
;; unexpanded, of which as much is told as makes it known.

(require (only-in "../../algebra/expression/simplifier.rkt" left-unexpanded?)
         "../../algebra/expression/write.rkt"
         "../../algebra/notation/formula.rkt")

(provide note-label note->text note->tree)

;; Before the content of the note.
(define (note-label n) (if (left-unexpanded? n) "left unexpanded:" "assuming"))

(define (content n)
  (if (left-unexpanded? n) (parameterize ([print-limit 24]) (cut-datum (cadr n))) n))

(define (note->text n) (format "; ~a ~a" (note-label n) (datum->text (content n))))
(define (note->tree n) (plain-datum->tree (content n)))
