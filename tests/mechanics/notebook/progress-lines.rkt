#lang racket/base
;; Lines of progress as messages, and when they are sent.

(require mechanics/error/progress
         mechanics/notebook/progress-port
         "../support/checks.rkt")

(define sent '())
(define port (progress-port (lambda (m) (set! sent (cons (hash-ref m 'text) sent)))))
(define (texts) (begin0 (reverse sent) (set! sent '())))

(test-case "a line is a message without the signs that move a terminal's cursor"
  (check-equal? (write-bytes (string->bytes/utf-8 "..\rπ: 3 of 5\e[K..") port 2 16) 14)
  (check-equal? (texts) '("π: 3 of 5")))

;; A clock that goes on by a second whenever it is read
(define (seconds)
  (define now 0)
  (lambda () (set! now (+ now 1000)) now))

(test-case "a long computation tells how far it is, and an empty line ends it"
  (parameterize ([current-reporter (reporter port (seconds))])
    (call-counting 'verify "cells" 5 (lambda (count!) (for ([k (in-range 1 6)]) (count! k)))))
  (check-equal? (texts)
                '("verify: 3 of 5 cells" "verify: 4 of 5 cells" "verify: 5 of 5 cells" "")))
