#lang racket/base
;; Common to all proofs: tactics, and lemmas that are proved there.

(require racket/file racket/runtime-path)

(provide proof-tactics derivative-tactics)

(define-runtime-path tactics-file "proof-tactics.v")
(define (proof-tactics) (file->string tactics-file))

;; Beside them, where derivatives are Coq's
(define-runtime-path derivatives-file "derivative-tactics.v")
(define (derivative-tactics) (file->string derivatives-file))
