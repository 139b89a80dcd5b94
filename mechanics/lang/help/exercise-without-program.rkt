#lang racket/base
;; Exercises of the book that have no program, since their answer is no formula and no number to
;; compare, each with the page that is nearest to it.

(provide exercises-without-program)

(define no-answer "It has no program: its answer is no formula that could be compared.")

;; (number page sentence)
(define exercises-without-program
  (for/list ([e (in-list '(("1.1" "chapter-1") ("1.2" "chapter-1") ("1.23" "chapter-1")
                           ("2.7" "chapter-2") ("2.13" "chapter-2")
                           ("9.1" "derivatives") ("9.2" "derivatives")))])
    (list (car e) (cadr e) no-answer)))
