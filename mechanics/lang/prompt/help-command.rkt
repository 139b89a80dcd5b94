#lang racket/base
;; The command ,help NAME is the form (help NAME), and ,help SOME WORDS is (help "SOME WORDS"),
;; if the language has them.

(require "typed-forms.rkt")

(provide help-on)

;; text : what follows ,help -> forms to evaluate
(define (help-on text)
  (cond [(memq 'help (namespace-mapped-symbols))
         (list (datum->syntax #f (list 'help (or (single-subject text) text))))]
        [else
         (printf "there is no help on names here; the manual has it: make docs\n")
         '()]))

;; -> identifier, a string as (help "words") has it, or #f
(define (single-subject text)
  (define forms (with-handlers ([exn:fail:read? (lambda (e) #f)]) (forms-in text)))
  (and (pair? forms)
       (null? (cdr forms))
       (or (identifier? (car forms)) (string? (syntax-e (car forms))))
       (car forms)))
