#lang racket/base
;; Documents: the finds of the search, with the texts that they are found by.

(require "words.rkt")

(provide (struct-out document)
         title-field
         in-number in-section-number in-title in-lesser-title in-page-title in-heading in-sentence
         in-text)

;; fields : ((weight . text) ...), a word counting as its best field
;; prior : a weight added whatever is looked for
(struct document (finding fields prior))

;; Weights of a word, by where it stands.
(define in-number 36)          ; 1.29 of exercise 1.29
(define in-section-number 24)
(define in-title 30)           ; divided among the words of the title
(define in-lesser-title 20)    ; of names rarely meant
(define in-page-title 12)
(define in-heading 9)
(define in-sentence 8)
(define in-text 2)

;; A title of few words is about each of them.
(define (title-field text [weight in-title])
  (cons (/ weight (expt (max 1 (length (telling-words text))) 0.45)) text))
