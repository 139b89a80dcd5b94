#lang racket/base
;; A residual with a number as small as rounding leaves, such as the sine of the decimal pi,
;; is refuted as the number it is.  That it may be meant otherwise is said.

(require "../algebra/expression/expression.rkt"
         "../generic/describe.rkt")

(provide remarks-on-rounding)

;; -> a list of no string or one
(define (remarks-on-rounding residual)
  (define found #f)
  (map-leaves (lambda (leaf)
                (when (expression? leaf) (set! found (or found (smallest-size leaf))))
                leaf)
              residual)
  (if found
      (list (format (string-append "~a may be no more than what rounding leaves, as of (sin pi): "
                                   "exact numbers would tell, ':pi for π")
                    (value->text found)))
      '()))

;; A flonum in e of the size of rounding, or #f.
(define (smallest-size e)
  (node-fold e
             (lambda (leaf) (and (flonum? leaf) (< 0.0 (abs leaf) rounding) leaf))
             (lambda (n parts) (ormap values parts))))

(define rounding 1e-14)
