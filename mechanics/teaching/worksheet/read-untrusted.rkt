#lang racket/base
;; Reads data that anybody may have written, without harm: no reader of another language, no
;; cycles, no compiled code, and no number or vector such as #e1e999999999 and #999999999(0) that
;; would fill the memory.

(provide read-untrusted many-digits?)

;; string -> its first datum, or an error of the reader
(define (read-untrusted text)
  (when (many-digits? text)
    (error 'read-untrusted "a number has more digits than any answer needs"))
  (call-with-default-reading-parameterization
   (lambda ()
     (parameterize ([read-accept-reader #f] [read-accept-lang #f] [read-accept-graph #f]
                    [read-accept-compiled #f]
                    [current-readtable without-prefixes])
       (read (open-input-string text))))))

;; Are there so many in a row?  A regular expression would take seconds for millions of characters.
(define (many-digits? text)
  (for/fold ([n 0] #:result (>= n most-digits)) ([c (in-string text)] #:break (>= n most-digits))
    (if (char<=? #\0 c #\9) (+ n 1) 0)))

(define most-digits 2000)

;; Racket's `write` gives no number a prefix, and no vector a length: #9(0) has nine elements.
(define (refuse prefix)
  (error 'read-untrusted "a number or a vector has the prefix #~a" prefix))

;; #f, and not #fl9(0)
(define (read-false c in . _)
  (when (regexp-try-match #px"^[lxLX][0-9]" in) (refuse c))
  (regexp-try-match #px"^alse" in)
  #f)

(define without-prefixes
  (for/fold ([table (make-readtable #f #\f 'dispatch-macro read-false)])
            ([c (in-string "eixobdEIXOBD0123456789")])
    (make-readtable table c 'dispatch-macro (lambda (c . _) (refuse c)))))
