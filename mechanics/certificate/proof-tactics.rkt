#lang racket/base
;; Common to all proofs: tactics, and lemmas that are proved there.

(require racket/file racket/promise racket/runtime-path)

(provide proof-tactics derivative-tactics angle-definition names-in-tactics)

(define-runtime-path tactics-file "proof-tactics.v")
(define tactics (delay (file->string tactics-file)))
(define (proof-tactics) (force tactics))

;; Beside them, where derivatives are Coq's
(define-runtime-path derivatives-file "derivative-tactics.v")
(define of-derivatives (delay (file->string derivatives-file)))
(define (derivative-tactics) (force of-derivatives))

;; Before a theorem that speaks of angles of points
(define-runtime-path angle-file "angle-definition.v")
(define of-angles (delay (file->string angle-file)))
(define (angle-definition) (force of-angles))

;; The names that these define
(define (names-in-tactics) (force names))
(define names
  (delay
    (map cadr (regexp-match* #px"(?m:^(?:Lemma|Ltac|with|Definition) (\\w+))"
                             (string-append (proof-tactics) (derivative-tactics)
                                            (angle-definition))
                             #:match-select values))))
