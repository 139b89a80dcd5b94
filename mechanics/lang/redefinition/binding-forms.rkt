#lang racket/base
;; Forms as they are written, before they are expanded: which define, which make procedures, which
;; bind.  A keyword is recognized by its binding, not by its spelling.

(require "definition-head.rkt"
         (only-in "../pattern/pattern-syntax.rkt" head-name)
         (for-template racket/base (prefix-in pattern: "../pattern/pattern.rkt")))

(provide among? definition-forms procedure-forms let-forms sequential-let-forms
         defined-by-define definition-header run-by-definition?)

(define (among? id ids)
  (and (identifier? id)
       (ormap (lambda (other) (free-identifier=? id other)) ids)))

(define definition-forms (list #'pattern:define #'define))
(define procedure-forms (list #'pattern:lambda #'pattern:λ #'lambda #'λ))
(define let-forms (list #'pattern:let #'pattern:let* #'let #'let* #'letrec))
(define sequential-let-forms (list #'pattern:let* #'let*))

;; The name that a `define` defines, or #f if the form is none.
(define (defined-by-define form)
  (syntax-case form ()
    [(keyword head . _)
     (among? #'keyword definition-forms)
     (head-name #'head)]
    [_ #f]))

;; The first call of the procedure that a `define` defines, as a datum: (L m k) of
;; ((L m k) local); or the name of a value that is no procedure.
(define (definition-header form) (head->header (definition-head (syntax->datum form))))

;; Of a definition (define id expression): is the expression more than a procedure
;; that is written out?
(define (run-by-definition? body)
  (syntax-case body ()
    [((keyword . _)) (not (among? #'keyword procedure-forms))]
    [_ #t]))
