#lang racket/base
;; Sums and products over sequences, generic.

(require (for-syntax racket/base syntax/for-body)
         "arithmetic.rkt")

(provide g:for/sum g:for/product g:for*/sum g:for*/product)

(define-syntax-rule (define-accumulation id for/fold/derived start combine)
  (define-syntax (id stx)
    (syntax-case stx ()
      [(_ clauses body (... ...))
       (with-syntax ([original stx]
                     [((before (... ...)) (after (... ...)))
                      (split-for-body stx #'(body (... ...)))])
         #'(for/fold/derived original ([total start]) clauses
             before (... ...)
             (combine total (let () after (... ...)))))])))

(define-accumulation g:for/sum for/fold/derived 0 g:+)
(define-accumulation g:for/product for/fold/derived 1 g:*)
(define-accumulation g:for*/sum for*/fold/derived 0 g:+)
(define-accumulation g:for*/product for*/fold/derived 1 g:*)
