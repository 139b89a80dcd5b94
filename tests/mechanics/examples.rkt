#lang racket/base
;; The examples, each a program with tests.  Exercises, figures and animations have files of
;; their own here; the others are run by this one.

(require (only-in mechanics/book)
         (only-in mechanics/geometry)
         (only-in mechanics/plot)
         racket/path
         racket/runtime-path
         racket/string
         "support/checks.rkt" "runner/discover.rkt"
         "support/example-programs.rkt")

(define-runtime-path examples "../../examples/mechanics")
(define folder (simplify-path examples))

;; exercises.rkt, show/plot/figures.rkt and show/animation/programs.rkt
(define run-elsewhere
  #rx"^exercises/exercise-.*[.]rkt$|^figures/[^/]*-[^/]*[.]rkt$|^animations/[^/]*[.]rkt$")

(define (name-of file) (path->string (find-relative-path folder file)))

(define programs
  (filter (lambda (file) (not (regexp-match? run-elsewhere (name-of file)))) (example-files)))

(define-namespace-anchor here)

(test-case "there are examples to run"
  (check-true (> (length programs) 35)))

(for ([program (in-list programs)])
  (define name (name-of program))
  (define space (loaded-from here 'rackunit 'mechanics 'mechanics/book 'mechanics/plot
                             'mechanics/geometry))
  (alone (format "the tests of ~a" name)
         (test-case (format "nothing opaque is in what ~a prints" name)
           (check-false (string-contains? (run-example space program) "#<")))
         (test-example space program)))
