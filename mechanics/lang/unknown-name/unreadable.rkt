#lang racket/base
;; Racket's messages on text that cannot be read, for a parenthesis or a quote too many or too few,
;; in plain words.

(provide unreadable unclosed)

(define read-message #px"^.*?:([0-9]*):[0-9]*: read(?:-syntax)?: (.*)$")

;; exn:fail:read -> number of the line or #f, and the mistake there
(define (unreadable e)
  (define found (regexp-match read-message (exn-message e)))
  (if found
      (values (string->number (cadr found)) (in-words (caddr found)))
      (values #f (in-words (regexp-replace #px"^read(?:-syntax)?: " (exn-message e) "")))))

(define (in-words text)
  (regexp-replaces
   text
   '([#px"^expected a `.` to close `(.)`\n  possible cause: (.*)"
      "the \\1 there is never closed\n  \\2"]
     [#px"^expected a `.` to close `(.)`.*" "the \\1 there is never closed"]
     [#px"^unexpected `(.)`.*" "there is a \\1 too many"]
     [#px"^(?:missing|expected) `.` to close preceding `(.)`[^\n]*, found instead `(.)`.*"
      "the \\1 there is closed by a \\2"]
     [#px"^bad syntax `(#.).*" "\\1 is not read; a comment begins with a semicolon"]
     [#px"^expected a closing `\"`.*" "the \" there has no other to close it"])))

;; The sign that is missing, by an exn:fail:read:eof: ) or \" mostly
(define (unclosed e)
  (define found (or (regexp-match #px"expected a `(.)` to close" (exn-message e))
                    (regexp-match #px"expected a closing `(\")`" (exn-message e))))
  (and found (cadr found)))
