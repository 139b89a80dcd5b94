#lang racket/base
;; A reader's choices for the look of formulas.

(require "../../error/complain.rkt")

(provide derivative-style suppress-arguments)

;; How derivatives of functions of one variable are marked: by dots or by D.  'automatic:
;; those of functions of t by up to three dots where a formula is drawn, by D on one line.
(define derivative-style
  (make-parameter 'automatic
                  (lambda (style)
                    (unless (memq style '(automatic dots D))
                      (complain-of-datum 'derivative-style "'automatic, 'dots or 'D" style))
                    style)))

;; Symbols: a literal function applied to these alone is shown without its arguments.
(define suppress-arguments
  (make-parameter '()
                  (lambda (names)
                    (unless (and (list? names) (andmap symbol? names))
                      (complain-of-datum 'suppress-arguments
                                         "a list of symbols, such as '(t)" names))
                    names)))
