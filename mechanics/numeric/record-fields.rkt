#lang racket/base
;; The fields of a record under their own names, for methods that use many of them.

(require (for-syntax racket/base))

(provide define-fields)

;; (define-fields point p x y) defines x as (point-x p) and y as (point-y p).
(define-syntax (define-fields stx)
  (syntax-case stx ()
    [(_ record value field ...)
     (with-syntax ([(accessor ...) (map (accessor-of #'record) (syntax->list #'(field ...)))])
       #'(begin (define field (accessor value)) ...))]))

(define-for-syntax ((accessor-of record) field)
  (datum->syntax field
                 (string->symbol (format "~a-~a" (syntax-e record) (syntax-e field)))
                 field))
