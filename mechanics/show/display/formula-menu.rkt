#lang racket/base
;; The menu of a formula in an editor: what can be copied of it.

(require "result-formula.rkt"
         "../typesetting/MathML.rkt" "../typesetting/TeX.rkt" "../typesetting/break.rkt"
         "../typesetting/drawn-text.rkt"
         "../../algebra/notation/infix.rkt"
         racket/class racket/gui/base)

(provide formula-menu formula-copies)

(define (formula-menu f)
  (define menu (new popup-menu%))
  (for ([c (in-list formula-copies)])
    (new menu-item% [parent menu] [label (car c)]
         [callback (lambda (item event)
                     (send the-clipboard set-clipboard-string ((cdr c) f)
                           (send event get-time-stamp)))]))
  menu)

;; (label . (formula -> text))
(define formula-copies
  (let ([cut (lambda (f) (fit (formula-body f) (formula-width f)))])
    (list (cons "Copy as S-Expression" formula-program)
          (cons "Copy as TeX" (lambda (f) (tree->TeX (cut f))))
          (cons "Copy as MathML" (lambda (f) (tree->MathML (cut f) #t)))
          (cons "Copy as One Line" (lambda (f) (tree->line (formula-body f))))
          (cons "Copy as Text" (lambda (f) (tree->text (cut f)))))))
