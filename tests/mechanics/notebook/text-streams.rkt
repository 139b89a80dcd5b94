#lang racket/base
;; The output of a program, as it is sent on: whole characters, and no more than a million bytes.

(require mechanics/notebook/text-stream
         "../support/checks.rkt")

;; -> a stream, and -> the texts that it sent, in order
(define (stream-and-texts)
  (define sent '())
  (values (make-text-stream (lambda (text) (set! sent (cons text sent))))
          (lambda () (reverse sent))))

(test-case "characters of one to four bytes are whole, wherever what is written is cut"
  (define text "a\u00DF\u20AC\U1F600z")
  (define bytes (string->bytes/utf-8 text))
  (for* ([i (in-range (+ 1 (bytes-length bytes)))] [j (in-range i (+ 1 (bytes-length bytes)))])
    (define-values (s texts) (stream-and-texts))
    (for ([part (list (subbytes bytes 0 i) (subbytes bytes i j) (subbytes bytes j))])
      (write-bytes part (text-stream-port s))
      (send-rest! s))
    (check-equal? (apply string-append (texts)) text)))

(test-case "beyond a million bytes of a cell they are counted; the next cell begins anew"
  (define-values (s texts) (stream-and-texts))
  (define (write-lines n)
    (for ([_ n])
      (write-string (make-string 1000 #\x) (text-stream-port s))
      (send-rest! s)))
  (write-lines 1003)
  (check-equal? (apply + (map string-length (texts))) 1000000)
  (check-equal? (left-out s) 3000)
  (begin-cell! s)
  (check-equal? (left-out s) 0)
  (write-lines 2)
  (check-equal? (apply + (map string-length (texts))) 1002000))
