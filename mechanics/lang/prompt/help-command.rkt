#lang racket/base
;; The command ,help NAME is the form (help NAME), if the language has it.

(require "form.rkt")

(provide help-on)

;; text : what follows ,help -> forms to evaluate
(define (help-on text)
  (define names (or (forms-in text) '()))
  (cond [(not (and (pair? names) (null? (cdr names)) (identifier? (car names))))
         (printf ",help takes one name, as in ,help Lagrange-equations\n")
         '()]
        [(memq 'help (namespace-mapped-symbols))
         (list (datum->syntax #f (list 'help (car names))))]
        [else
         (printf "there is no help on names here; the manual has it: make docs\n")
         '()]))
