#lang racket/base
;; Says that the library is not compiled, where a facade is compiled in memory.  A facade begins
;; with this, before it requires the rest, so that a reader is told before the wait, also where a
;; compilation was broken off and this file alone is compiled; in the compiled form of a facade
;; nothing of it is left.

(require (for-syntax racket/base "compiling-note.rkt"))

(provide tell-if-uncompiled)

(define-syntax (tell-if-uncompiled stx)
  (tell-of-compiling (syntax-source stx))
  #'(begin))
