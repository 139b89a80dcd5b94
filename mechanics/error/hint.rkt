#lang racket/base
;; What to type instead, said at the end of a message, on a line of its own; "" where
;; there is nothing to say.

(provide list-hint not-a-tuple symbols-hint values-first)

;; Lists are what a reader of other languages writes for tuples.
(define (list-hint x [instead "(up x y ...)"])
  (if (or (pair? x) (null? x))
      (string-append "\n  " (not-a-tuple instead))
      ""))

(define (not-a-tuple instead) (format "a list is not a tuple; use ~a" instead))

;; Where only a number will do, and an expression was given.
(define values-first "give its symbols values first")
(define symbols-hint (string-append "\n  " values-first))
