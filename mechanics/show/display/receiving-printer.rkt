#lang racket/base
;; Who takes results as they are, to show them in a way of his own: a value of `current-print`
;; that is not given the text that others print.

(provide (struct-out result-receiver) (struct-out output-receiver) receiver-here)

;; receive : value -> any
(struct result-receiver (receive)
  #:property prop:procedure (struct-field-index receive))

;; It takes values printed on the port as well, as `print-expression` does.
(struct output-receiver result-receiver (port))

;; The receiver of values to be printed on the present output, or #f
(define (receiver-here)
  (define printer (current-print))
  (and (output-receiver? printer)
       (eq? (current-output-port) (output-receiver-port printer))
       printer))
