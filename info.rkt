#lang info
(define collection 'multi)
(define version "0.3")
(define license 'MIT)
(define pkg-desc
  (string-append "Classical mechanics in the language of SICM: Lagrangians, Hamiltonians, "
                 "and solutions checked as residuals"))
(define pkg-authors '("the mechanics authors"))
(define deps '(("base" #:version "8.7")
               "draw-lib"
               "gui-lib"
               "math-lib"
               "pict-lib"
               "rackunit-lib"
               "readline-lib"
               "sandbox-lib"
               "snip-lib"
               "syntax-color-lib"
               "wxme-lib"))
(define build-deps '("at-exp-lib"
                     "drracket-tool-text-lib"
                     "plot-lib"
                     "racket-doc"
                     "scribble-lib"))
