#lang racket/base
;; What all proofs have in common: tactics, and lemmas that are proved there.

(require racket/file racket/runtime-path)

(provide proof-tactics)

(define-runtime-path tactics-file "proof-tactics.v")
(define (proof-tactics) (file->string tactics-file))
