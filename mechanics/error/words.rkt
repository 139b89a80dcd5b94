#lang racket/base
;; Words put together, for messages and reports.

(require racket/list)

(provide message joined counted)

;; "who: " and the text, which with its parts is as `format` takes them.
(define (message who text parts)
  (format "~a: ~a" who (apply format text parts)))

;; "a, b, c"
(define (joined texts [separator ", "])
  (apply string-append (add-between texts separator)))

;; "1 argument", "2 arguments"
(define (counted n noun)
  (format "~a ~a~a" n noun (if (eqv? n 1) "" "s")))
