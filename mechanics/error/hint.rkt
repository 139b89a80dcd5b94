#lang racket/base
;; What to type instead, said at the end of a message, on a line of its own; "" where
;; there is nothing to say.

(provide list-hint)

;; Lists are what a reader of other languages writes for tuples.
(define (list-hint x [instead "(up x y ...)"])
  (if (or (pair? x) (null? x))
      (format "\n  a list is not a tuple; use ~a" instead)
      ""))
