#lang racket/base
;; Hints, the text to type instead, on a line of its own at the end of a message; "" where
;; there is nothing to say.

(require "../operation/operation-column.rkt")

(provide list-hint quoted-expression? quoted-hint quoted-name-hint
         not-a-tuple symbols-hint values-first)

;; Readers of other languages write lists for tuples.
(define (list-hint x [instead "(up x y ...)"])
  (cond [(quoted-expression? x) (quoted-hint x)]
        [(or (pair? x) (null? x)) (string-append "\n  " (not-a-tuple instead))]
        [else ""]))

;; '(+ a a) is a list, which looks like an expression when it is printed.
(define (quoted-hint x)
  (if (quoted-expression? x)
      "\n  a quoted list is no expression; read-expression makes one of it"
      ""))

(define (quoted-expression? x)
  (and (list? x)
       (pair? x)
       (memq (car x) heads)
       #t))

(define heads (append '(square cube up down) (operation-names arithmetic function reciprocal)))

(define (not-a-tuple instead) (format "a list is not a tuple; use ~a" instead))

;; For a quoted name given where a function is wanted; else "".
(define (quoted-name-hint x)
  (if (symbol? x)
      (format "\n  with its quote it is only a name; the function itself is ~a" x)
      ""))

;; For an expression given where only a number will do.
(define values-first "give its symbols values first")
(define symbols-hint (string-append "\n  " values-first))
