#lang racket/base
;; The claims of claims.rktd, asked: each with its verdict.

(require racket/file racket/runtime-path
         mechanics (only-in mechanics/book))

(provide proved-claims (struct-out asked))

;; name : symbol; program : datum
(struct asked (name program verdict) #:authentic)

(define-runtime-path claims-file "claims.rktd")

(define-namespace-anchor here)

;; chosen : names, or #f for all
(define (proved-claims [chosen #f])
  (define namespace (make-base-empty-namespace))
  (define own (namespace-anchor->empty-namespace here))
  (parameterize ([current-namespace namespace])
    (for ([m (in-list '(mechanics mechanics/book))])
      (namespace-attach-module own m)
      (namespace-require m)))
  (for/list ([c (in-list (file->list claims-file))]
             #:when (or (not chosen) (memq (car c) chosen)))
    (asked (car c) (cadr c) (eval (cadr c) namespace))))
