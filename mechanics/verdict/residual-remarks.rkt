#lang racket/base
;; Remarks beside a verdict for which the residual alone gives cause.
;;
;; A number as small as rounding leaves, such as the sine of the decimal pi, is refuted as a
;; factor, being a number like others, and undecided where it stands alone.  A symbol that
;; is spelt like π is an unknown.  Either may be meant otherwise.

(require (only-in racket/list append-map)
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../generic/describe.rkt")

(provide remarks-on-rounding remarks-on-pi)

;; Each -> a list of at most one string

;; default : the number to speak of where simplification made an exact 0 of it
(define (remarks-on-rounding residual [default #f])
  (define found (or (ormap smallest-size (expressions-of residual)) default))
  (cond [(not found) '()]
        [(zero? found)
         (list (string-append "exact numbers would tell: 49/5 for 9.8, ':pi for π, "
                              "(sqrt 2) for the root of 2"))]
        [else
         (list (format (string-append "~a may be no more than what rounding leaves, as of "
                                      "(sin pi): exact numbers would tell, ':pi for π, "
                                      "(sqrt 2) for the root of 2")
                       (value->text found)))]))

;; A flonum in e of the size of rounding, or #f.
(define (smallest-size e)
  (if (flonum? e)
      (and (< (abs e) rounding) e)
      (some-leaf? (lambda (leaf) (and (flonum? leaf) (< 0.0 (abs leaf) rounding) leaf)) e)))

(define rounding 1e-14)

(define (remarks-on-pi x)
  (define name
    (for/or ([s (in-list (append-map symbols-in (expressions-of x)))]) (and (memq s spelt-pi) s)))
  (if name
      (list (format "the symbol ~a is an unknown like others; the number π is written ':pi" name))
      '()))

(define spelt-pi '(pi Pi PI π))

(define (expressions-of x) (filter expression? (leaves x)))
