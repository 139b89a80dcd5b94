#lang racket/base
;; (help name), (help "words") and (help): cards of names, made of the manual.
;;
;; A macro, so that the name need not be quoted, nor have a value; a quote makes no difference.
;; The printer of cards and their table are loaded at the first use.

(require (for-syntax racket/base)
         "../../generic/on-demand.rkt")

(provide help)

(require-on-demand ["help-answer.rkt" help-about])

(define-syntax (help stx)
  (syntax-case stx (quote)
    [(_) #'(#%plain-app help-about '#f)]
    [(_ 'name) (identifier? #'name) #'(#%plain-app help-about 'name)]
    [(_ about) (or (identifier? #'about) (string? (syntax-e #'about)))
               #'(#%plain-app help-about 'about)]
    [_ (raise-syntax-error
        #f "ask (help), (help verify-solution) or (help \"constraint\")" stx)]))
