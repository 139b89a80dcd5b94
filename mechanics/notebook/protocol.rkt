#lang racket/base
;; Messages between the process that evaluates cells and the one that speaks Jupyter's protocol:
;; JSON objects on two descriptors of their own, each after its length in bytes and a newline, so
;; that no output of a program can be taken for one.

(require json)

(provide read-message make-sender)

;; -> hash of symbols, or eof where the other process has ended
(define (read-message in)
  (define length (read-line in))
  (define text (if (eof-object? length) eof (read-bytes (string->number length) in)))
  (if (eof-object? text) eof (bytes->jsexpr text)))

;; -> procedure that sends a message; of several threads each sends whole messages
(define (make-sender out)
  (define turn (make-semaphore 1))
  (lambda (message)
    (define text (jsexpr->bytes message))
    ;; a break would leave half a message
    (parameterize-break #f
      (call-with-semaphore turn
                           (lambda ()
                             (fprintf out "~a\n" (bytes-length text))
                             (write-bytes text out)
                             (flush-output out))))))
