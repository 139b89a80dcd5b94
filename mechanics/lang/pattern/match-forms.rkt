#lang racket/base
;; The forms of racket/match, which is loaded where one of them is first expanded: it would take a
;; seventh of the time in which mechanics is loaded.

(require (only-in racket/match/match-expander define-match-expander)
         (only-in racket/match/runtime match-equality-test exn:misc:match?)
         (for-syntax racket/base))

(provide define-match-expander match-equality-test exn:misc:match?)

(begin-for-syntax
  ;; The same form with the name that racket/match has for it.
  (define (matching name stx)
    (define form (syntax-local-lift-require 'racket/match (datum->syntax #f name stx)))
    (syntax-case stx ()
      [(_ . rest) (datum->syntax stx (cons form #'rest) stx stx)]
      [_ (datum->syntax stx form stx stx)])))

(define-syntax-rule (define-forms name ...)
  (begin
    (provide name ...)
    (define-syntax (name stx) (matching 'name stx)) ...))

(define-syntax-rule (define-patterns name ...)
  (begin
    (provide name ...)
    (define-match-expander name (lambda (stx) (matching 'name stx))) ...))

(define-forms
  match match* match/values match-lambda match-lambda* match-lambda** match-let match-let*
  match-let-values match-let*-values match-letrec match-letrec-values match-define
  match-define-values match/derived match*/derived define/match failure-cont)
(define-patterns == struct*)
