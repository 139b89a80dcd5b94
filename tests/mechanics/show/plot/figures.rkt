#lang racket/base
;; The figures are programs, and other programs draw figures: each writes its picture to
;; the file named on its command line.  The drawings are tested beside them, which is run here.

(require (only-in mechanics/book)
         (only-in mechanics/plot)
         (only-in mechanics/show/plot/on-demand why-not)
         (only-in racket/class send)
         racket/file
         racket/lazy-require
         racket/list
         racket/path
         racket/runtime-path
         racket/string
         "../../support/checks.rkt"
         "../../support/example-programs.rkt" "../../support/picture-programs.rkt"
         "../../support/skip.rkt")

(lazy-require [racket/draw (read-bitmap)])

(define-runtime-path figures "../../../../examples/mechanics/figures")
(define-runtime-path constraints "../../../../examples/mechanics/constraints")
(define-runtime-path manual "../../../../scribblings/mechanics")

(define (name-of file) (path->string (file-name-from-path file)))

(define programs
  (for/list ([file (in-list (directory-list figures #:build? #t))]
             #:when (regexp-match? #rx"^[^.].*-.*[.]rkt$" (name-of file)))
    file))

;; In the manual's sources
(test-case "the manual leads to each figure"
  (define text
    (string-append*
     (for/list ([f (in-directory manual)] #:when (path-has-extension? f #".scrbl"))
       (file->string f))))
  (check-equal? (for/list ([program (in-list programs)]
                           #:unless (string-contains? text (string-append "figures/"
                                                                          (name-of program))))
                  (name-of program))
                '()))

(define-namespace-anchor here)

(define libraries '(rackunit mechanics mechanics/book mechanics/plot))

(define (make-namespace) (apply loaded-from here libraries))

;; Its output, run as a program with these arguments; again in another namespace, where
;; it was not run before.
(define (run program #:in [namespace (make-namespace)] . arguments)
  (apply run-example namespace `(submod ,program main) arguments))

;; Loads the drawing library, or finds that it is not there.
(define problem (why-not))

;; Programs that are run once share what they load.
(define shared
  (if problem (make-namespace) (apply loaded-from here 'mechanics/show/plot/picture libraries)))

(test-case "all figures are there"
  (check-equal? (length programs) 80))

(skip-unless (not problem)
             "the shared libraries of racket/draw are not installed: no figures"

  (test-case "systems with constraints write pictures"
    (in-a-folder
     (run (build-path constraints "Atwood-machines.rkt"))
     (check-equal? (map path->string (directory-list)) '("Atwood-machines.png")))
    (for ([file (in-list (directory-list constraints #:build? #t))]
          #:when (path-has-extension? file #".rkt")
          #:when (regexp-match? #rx"mechanics/plot" (file->string file)))
      (check-true (module-declared? `(submod ,file main) #t) (name-of file))))

  (test-case "without a name it takes its own; two names are too many"
    (in-a-folder
     (run (build-path figures "figure-1-2.rkt"))
     (check-equal? (map path->string (directory-list)) '("figure-1-2.png"))
     (check-exn #rx"expected the name of one file, ending in .png, .svg or .pdf"
                (lambda () (run (build-path figures "figure-1-2.rkt") "a.png" "b.png"))))))

;; ---------------------------------------------------------------------------
;; Each, and what is tested beside it

(define (check-writes program extension)
  (in-a-folder
   (define file (string-append "picture." extension))
   (define printed (run program file #:in shared))
   (check-frame printed)
   (check-true (string-suffix? printed (format "written: ~a\n" file)) printed)
   (check-equal? (map path->string (directory-list)) (list file))
   (check-true (> (file-size file) 2500))
   (check-drawn file extension)))

;; It is told from where to where the axes go, and that something is drawn.
(define (check-frame printed)
  (define m
    (regexp-match (pregexp (format "^\\(frame x from ~a to ~a, y from ~a to ~a: \\d+ \\w+"
                                   number number number number))
                  printed))
  (define ends (if m (map string->number (cdr m)) '()))
  (with-check-info (['printed printed])
    (check-equal? (length ends) 4)
    (check-true (and (< (first ends) (second ends)) (< (third ends) (fourth ends))))))

(define number "([-+\\d.e]+)")

;; A picture that is empty has the size of one that is not, or nearly.
(define (check-drawn file extension)
  (check-true (case extension
                [("svg") (regexp-match? #rx#"<svg .*<(path|circle|image|use) .*</svg>"
                                        (file->bytes file))]
                [("pdf") (regexp-match? #rx#"^%PDF-.*%%EOF" (file->bytes file))]
                [else (> (length (colors-of file)) 2)])
              file))

;; -> the colours, as bytes, that occur in every tenth column
(define (colors-of file)
  (define bitmap (read-bitmap file))
  (define-values (width height) (values (send bitmap get-width) (send bitmap get-height)))
  (define column (make-bytes (* 4 height)))
  (define colors (make-hash))
  (for ([x (in-range 0 width 10)])
    (send bitmap get-argb-pixels x 0 1 height column)
    (for ([y (in-range height)]) (hash-set! colors (subbytes column (* 4 y) (* 4 (+ y 1))) #t)))
  (hash-keys colors))

(for ([program (in-list programs)] [extension (in-cycle '("svg" "png" "pdf"))])
  (define name (name-of (path-replace-extension program #"")))
  (alone (format "the tests of ~a" name)
         (unless problem
           (test-case (format "~a writes a picture in ~a" name extension)
             (check-writes program extension)))
         (test-example shared program)))
