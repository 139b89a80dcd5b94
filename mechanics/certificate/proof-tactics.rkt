#lang racket/base
;; Common to all proofs: tactics, and lemmas that are proved there.

(require racket/file racket/promise racket/runtime-path)

(provide proof-tactics derivative-tactics names-in-tactics)

(define-runtime-path tactics-file "proof-tactics.v")
(define tactics (delay (file->string tactics-file)))
(define (proof-tactics) (force tactics))

;; Beside them, where derivatives are Coq's
(define-runtime-path derivatives-file "derivative-tactics.v")
(define of-derivatives (delay (file->string derivatives-file)))
(define (derivative-tactics) (force of-derivatives))

;; The names that both define
(define (names-in-tactics) (force names))
(define names
  (delay
    (map cadr (regexp-match* #px"(?m:^(?:Lemma|Ltac|with) (\\w+))"
                             (string-append (proof-tactics) (derivative-tactics))
                             #:match-select values))))
