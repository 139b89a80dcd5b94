#lang racket/base
;; The menu of a formula in an editor: forms of it to copy.

(require "formula-text.rkt" "result-formula.rkt"
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

(define ((copy-in format) f) (tree-in-format (formula-body f) (formula-width f) format))

;; (label . (formula -> text))
(define formula-copies
  (list (cons "Copy as S-Expression" formula-program)
        (cons "Copy as TeX" (copy-in 'TeX))
        (cons "Copy as MathML" (copy-in 'MathML))
        (cons "Copy as One Line" (copy-in 'infix))
        (cons "Copy as Text" (copy-in 'text))))
