#lang racket/base
;; The animations are programs: each writes the files that are named on its command line.
;; Their motions are tested beside them, which is run here.

(require (only-in mechanics/animate)
         (only-in mechanics/show/animation/on-demand why-no-pictures)
         (only-in mechanics/book)
         (only-in mechanics/geometry)
         racket/file
         racket/path
         racket/runtime-path
         racket/string
         "../../support/checks.rkt" "../../support/example-programs.rkt" "../../support/gif.rkt"
         "../../support/picture-programs.rkt" "../../support/skip.rkt")

(define-runtime-path folder "../../../../examples/mechanics/animations")

(define (name-of file) (path->string (path-replace-extension (file-name-from-path file) #"")))

(define programs
  (for/list ([file (in-list (directory-list folder #:build? #t))]
             #:when (path-has-extension? file #".rkt")
             #:unless (equal? (name-of file) "save"))
    file))

(define-namespace-anchor here)

(define (make-namespace)
  (loaded-from here 'rackunit 'mechanics 'mechanics/animate 'mechanics/book 'mechanics/geometry))

;; Its output, run as a program with these arguments; again in another namespace, where
;; it was not run before.
(define (run program #:in [namespace (make-namespace)] . arguments)
  (apply run-example namespace `(submod ,program main) arguments))

;; Loads the drawing library, or finds that it is not there.
(define problem (why-no-pictures))

;; Programs that are run once share what they load.
(define shared (make-namespace))

(test-case "all animations are there"
  (check-equal? (length programs) 14))

(skip-unless (not problem)
             "the shared libraries of racket/draw are not installed: no animations"

  (test-case "without a name it writes a GIF of its own"
    (in-a-folder
     (run (build-path folder "Atwood-machines.rkt"))
     (check-equal? (map path->string (directory-list)) '("Atwood-machines.gif"))
     (check-true (> (length (gif-images (parse-gif (file->bytes "Atwood-machines.gif")))) 50)))))

;; ---------------------------------------------------------------------------
;; Each, and what is tested beside it

(define (check-writes program)
  (in-a-folder
   (define printed (run program "motion.html" #:in shared))
   (check-true (string-prefix? printed "(animation from ") printed)
   (check-true (string-suffix? printed "written: motion.html\n") printed)
   (check-equal? (map path->string (directory-list)) '("motion.html"))
   (check-true (< 20000 (file-size "motion.html") 1000000))))

(for ([program (in-list programs)])
  (alone (format "the tests of ~a" (name-of program))
         (unless problem
           (test-case (format "~a writes a page" (name-of program))
             (check-writes program)))
         (test-example shared program)))
