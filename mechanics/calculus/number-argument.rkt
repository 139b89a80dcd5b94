#lang racket/base
;; Where only numbers will do: what the numerical algorithms are given.

(require "perturbed-value.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt"
         "../error/hint.rkt"
         "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/multiplied-function.rkt"
         "../generic/wrong-argument.rkt")

(provide number number-beneath check-function-of-one-variable)

;; x, known to be a real number; one of higher precision as one of Racket's, exact; one that
;; π is in as a flonum.
(define (number who x)
  (cond [(real? x) x]
        [(other-number? x) (comparand x)]
        [(and (symbolic? x) (constant-value x))]
        [else
         (complain-of-argument who "a real number" x
                               (if (symbolic? x)
                                   (string-append symbols-hint ": (substitute expression 'm 3 ...)")
                                   (string-append (multiplied-hint x) (list-hint x))))]))

;; The same of an x that may be in the course of being differentiated
(define (number-beneath who x) (number who (innermost x)))

(define (check-function-of-one-variable who f)
  (unless (and (procedure? f) (accepts? f 1))
    (raise-other-function who "a function of one variable" f)))
