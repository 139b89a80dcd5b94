#lang racket/base
;; Data that a page's script reads: frequent parts stand there once and are told by their numbers;
;; the text ends where its element does, and nowhere before.

(require racket/string)

(provide make-numbering number-of! numbered inside-script)

;; Things are numbered in the order of their first occurrence.
(define (make-numbering) (make-hash))

(define (number-of! numbering x)
  (define next (hash-count numbering))
  (hash-ref! numbering x next))

(define (numbered numbering)
  (map car (sort (hash->list numbering) < #:key cdr)))

(define (inside-script text)
  (string-replace (string-replace text "</" "<\\/") "<!" "\\u003c!"))
