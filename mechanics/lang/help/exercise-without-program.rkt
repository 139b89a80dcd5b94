#lang racket/base
;; Exercises of the book that have no program of their own, each with the reason and with the page
;; that is nearest to it.  A reason fits in the line of a finding.

(provide exercises-without-program)

;; (number page sentence)
(define exercises-without-program
  '(("1.1" "chapter-1" "No program: degrees of freedom are counted by looking.")
    ("1.2" "chapter-1" "No program: many coordinates are right, none is the answer.")
    ("1.23" "chapter-1" "No program: asked are the steps between two formulas.")
    ("2.7" "chapter-2" "No program of its own; this page is the nearest.")
    ("2.13" "chapter-2" "No program of its own; this page is the nearest.")
    ("9.2" "derivatives" "The functions of exercise 9.1; its program has both forms.")))
