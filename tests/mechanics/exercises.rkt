#lang racket/base
;; The programs for the exercises: their list, their headings, and the look of their
;; output.  Its content is tested in them, which is run here.

(require (only-in mechanics/book)
         (only-in mechanics/plot)
         racket/file
         racket/list
         racket/runtime-path
         racket/string
         "support/checks.rkt" "../../scribblings/mechanics/exercises.rkt"
         "support/example-programs.rkt")

(define-runtime-path examples "../../examples/mechanics")

;; Exercises that have an answer to check, by chapter.
(define checkable
  (list (cons 1 (append (range 3 23) (range 24 45)))
        (cons 2 '(1 2 3 4 5 6 8 9 10 11 12 14 15 16 17 18 19 20 21))
        (cons 3 (range 1 17))
        (cons 4 (range 1 11))
        (cons 5 (range 1 22))
        (cons 6 (range 1 13))
        (cons 7 (range 1 6))
        (cons 9 '(1))))

(define all (append-map exercises (map car checkable)))

(define checkable-geometry
  '("1.1" "2.1" "2.2" "3.1" "3.2" "3.3" "4.1" "4.2" "4.3" "5.1" "5.2" "5.3" "6.1" "7.1" "7.2"
    "8.1" "8.2" "9.1" "9.2" "9.3" "9.5" "9.6" "9.7" "9.8" "9.9" "9.10"))

(define (program-of e) (build-path examples (exercise-file e)))
(define (source e) (file->string (program-of e)))
(define (number e between) (format "~a~a~a" (exercise-chapter e) between (exercise-number e)))

(test-case "each exercise that can be checked has its program, named after it"
  (for ([chapter (in-list checkable)])
    (check-equal? (map exercise-number (exercises (car chapter))) (cdr chapter)))
  (for ([e (in-list all)])
    (check-equal? (exercise-file e) (format "exercises/exercise-~a.rkt" (number e "-")))))

(test-case "so has each of Functional Differential Geometry, which examples.rkt runs"
  (define geometry (geometry-exercises))
  (check-equal? (for/list ([e (in-list geometry)]) (number e ".")) checkable-geometry)
  (for ([e (in-list geometry)])
    (check-equal? (exercise-file e)
                  (format "geometry/exercises/FDG-exercise-~a.rkt" (number e "-")))))

(test-case "each is a module of the readers' language, with tests of a right and a wrong attempt"
  (for ([e (in-list (append all (geometry-exercises)))])
    (define text (source e))
    (check-true (string-prefix? text "#lang mechanics\n") (exercise-file e))
    (check-true (string-contains? text "\n(module+ test\n") (exercise-file e))))

(test-case "subjects are short, and end without a stop"
  (for ([e (in-list (append all (geometry-exercises)))])
    (check-true (< (string-length (exercise-subject e)) 60) (exercise-file e))
    (for ([text (list (exercise-subject e) (exercise-checked e) (exercise-how e))])
      (check-false (string-suffix? text ".") (exercise-file e)))))

;; ---------------------------------------------------------------------------
;; Their output, and their tests

(define-namespace-anchor here)

(define (check-printed e text)
  (check-true (> (string-length text) 10) (exercise-file e))
  (check-false (string-contains? text "#<") text)
  (for ([line (in-list (string-split text "\n"))])
    (check-true (< (string-length line) 80) line)))

(for ([e (in-list all)])
  (define name (exercise-file e))
  (define program (program-of e))
  (define space (loaded-from here 'rackunit 'mechanics 'mechanics/book 'mechanics/plot))
  (alone (format "the tests of ~a" name)
         (test-case (format "what ~a prints fits a terminal, and nothing opaque is in it" name)
           (check-printed e (run-example space program)))
         (test-example space program)))
