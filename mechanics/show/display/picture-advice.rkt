#lang racket/base
;; Advice to a reader at a terminal about a value that a terminal cannot show, such as a
;; picture: a line that the prompt puts beneath it.

(provide prop:advice advice)

;; Its value is a procedure from the value to the text.
(define-values (prop:advice has-advice? advice-of) (make-struct-type-property 'advice))

;; -> text or #f
(define (advice x) (and (has-advice? x) ((advice-of x) x)))
