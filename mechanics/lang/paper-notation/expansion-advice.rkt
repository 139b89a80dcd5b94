#lang racket/base
;; Advice from the expansion of a program, for the message of an error that may come when it is
;; run: it is left on the stack while a name is looked up.

(require (for-syntax racket/base))

(provide advised advice-in
         (for-syntax with-advice advice-on))

(define key (make-continuation-mark-key 'advice))

;; (advised text reference)
(define-syntax-rule (advised text reference)
  (with-continuation-mark key text reference))

;; marks -> text or #f
(define (advice-in marks) (continuation-mark-set-first marks key))

;; The identifier carries the advice to the macro #%top, if it has no binding.
(begin-for-syntax
  (define (with-advice stx text) (if text (syntax-property stx 'mechanics:advice text) stx))
  (define (advice-on stx) (syntax-property stx 'mechanics:advice)))
