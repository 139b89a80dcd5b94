#lang racket/base
;; The command ,help NAME is the form (help NAME), and ,help SOME WORDS is (help "SOME WORDS"),
;; if the language has them.

(require "typed-forms.rkt")

(provide help-on)

;; text : what follows ,help -> forms to evaluate
(define (help-on text)
  (cond [(memq 'help (namespace-mapped-symbols))
         (list (datum->syntax #f (list 'help (or (single-name text) text))))]
        [else
         (printf "there is no help on names here; the manual has it: make docs\n")
         '()]))

;; -> identifier or #f
(define (single-name text)
  (define names (with-handlers ([exn:fail:read? (lambda (e) #f)]) (forms-in text)))
  (and (pair? names) (null? (cdr names)) (identifier? (car names)) (car names)))
