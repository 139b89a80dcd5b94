#lang racket/base
;; The animations as programs: they write the files that are named on the command line, or
;; a GIF of their own name; with --show they open a window.

(require mechanics/animate)

(provide save-animations)

(define (save-animations animation usual-name)
  (define arguments (vector->list (current-command-line-arguments)))
  (for ([argument (in-list (if (null? arguments) (list usual-name) arguments))])
    (cond [(equal? argument "--show") (animation-show animation)]
          [else
           (animation-save animation argument)
           (printf "written: ~a\n" argument)])))
