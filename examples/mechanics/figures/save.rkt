#lang racket/base
;; The figures as programs: they write their picture to the file that is named on the
;; command line, or to one of their own name.

(require mechanics/plot)

(provide save-figure)

(define (save-figure picture usual-name)
  (define arguments (vector->list (current-command-line-arguments)))
  (unless (<= (length arguments) 1)
    (raise-user-error "expected the name of one file, ending in .png, .svg or .pdf"))
  (define file (if (null? arguments) usual-name (car arguments)))
  (graphics-save picture file)
  (printf "written: ~a\n" file))
