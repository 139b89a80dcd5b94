#lang racket/base
;; Notes beneath a result: assumptions of its simplification, and parts that it left
;; unexpanded, of which as much is told as makes them known.

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
