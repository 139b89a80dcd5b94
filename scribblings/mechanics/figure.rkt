#lang racket/base
;; Picts in the manual: pictures in its pages, and words where it is text alone.

(require file/convertible)

(provide figure)

(struct figure (pict)
  #:property prop:custom-write (lambda (f port mode) (write-string words port))
  #:property prop:convertible
  (lambda (f request otherwise)
    (if (eq? request 'text) words (convert (figure-pict f) request otherwise))))

(define words "(a picture of the formula)")
