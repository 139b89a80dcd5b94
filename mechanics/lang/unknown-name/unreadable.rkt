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

(define closed-otherwise
  (pregexp (string-append "^(?:missing|expected) `(.)` to close preceding `(.)`[^\n]*, "
                          "found instead `(.)`")))

(define (in-words text)
  (cond [(regexp-match #px"^expected a `(.)` to close `(.)`(?:\n  possible cause: (.*))?" text)
         => (lambda (found)
              (format "the ~a there is never closed~a" (caddr found)
                      (if (cadddr found) (string-append "\n  " (cadddr found)) "")))]
        [(regexp-match #px"^unexpected `(.)`" text)
         => (lambda (found) (format "there is a ~a too many" (cadr found)))]
        [(regexp-match closed-otherwise text)
         => (lambda (found)
              (format "the ~a there is closed by a ~a" (caddr found) (cadddr found)))]
        [(regexp-match #px"^bad syntax `(#.)" text)
         => (lambda (found)
              (format "~a is not read; a comment begins with a semicolon" (cadr found)))]
        [(regexp-match? #px"^expected a closing `\"`" text)
         "the \" there has no other to close it"]
        [else text]))

;; The sign that is missing, by an exn:fail:read:eof: ) or \" mostly
(define (unclosed e)
  (define found (or (regexp-match #px"expected a `(.)` to close" (exn-message e))
                    (regexp-match #px"expected a closing `(\")`" (exn-message e))))
  (and found (cadr found)))
