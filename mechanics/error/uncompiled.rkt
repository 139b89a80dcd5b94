#lang racket/base
;; Says that the library is not compiled, when this file is compiled in memory.  The facades
;; require it first, so that a reader is told before the wait; in the compiled form nothing of
;; it is left.

(require (for-syntax racket/base "compiling-note.rkt"))

(define-values ()
  (let-syntax ([tell (lambda (stx) (tell-of-compiling (syntax-source stx)) #'(values))])
    (tell)))
