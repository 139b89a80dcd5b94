#lang racket/base
;; x ^ 2 and (^ x 2), as powers are written elsewhere.  At Racket's prompt `^` would be the
;; last result, which is of no help to whoever means a power.

(require (for-syntax racket/base))

(provide ^)

(define-syntax (^ stx)
  (raise-syntax-error '^ "powers are (expt x 2)" stx))
