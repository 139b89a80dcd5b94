#lang racket/base
;; Who takes results as they are, to show them in a way of his own: a value of `current-print`
;; that is not given the text that others print.

(provide (struct-out result-receiver))

;; receive : value -> any
(struct result-receiver (receive)
  #:property prop:procedure (struct-field-index receive))
