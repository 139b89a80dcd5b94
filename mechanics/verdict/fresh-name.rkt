#lang racket/base
;; Names for symbols that no program can write, when they are to be shown.

(provide unused-name)

;; base, or base1, base2 ... if the table has that already
(define (unused-name base taken)
  (for/first ([suffix (in-sequences '("") (in-naturals 1))]
              #:unless (hash-ref taken (string->symbol (format "~a~a" base suffix)) #f))
    (string->symbol (format "~a~a" base suffix))))
