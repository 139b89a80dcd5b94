#lang racket/base
;; Minima of functions made by the generic arithmetic (SICM p. 19).

(require "number.rkt"
         (prefix-in numeric: "../numeric/minimize.rkt"))

(provide minimize)

;; (argument value steps) of a minimum of f between low and high.
(define (minimize f low high #:tolerance [tolerance 1e-8])
  (check-function-of-one-variable 'minimize f)
  (numeric:minimize (lambda (x) (number 'minimize (f x)))
                    (number 'minimize low) (number 'minimize high)
                    #:tolerance tolerance))
