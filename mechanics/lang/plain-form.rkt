#lang racket/base
;; Racket's form behind a name that is ours too.

(provide plain-form)

;; stx with `form` in place of its keyword; stx may be the keyword alone.
(define (plain-form form stx)
  (if (identifier? stx)
      (datum->syntax form (syntax-e form) stx stx)
      (datum->syntax stx (cons form (cdr (syntax-e stx))) stx stx)))
