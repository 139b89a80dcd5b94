#lang racket/base
;; The programs for the exercises: which there are, and what each says of itself.  That they
;; print what they should is tested in them.

(require racket/file
         racket/list
         racket/runtime-path
         racket/string
         rackunit
         "../../scribblings/mechanics/exercises.rkt")

(define-runtime-path folder "../../examples/mechanics/exercises")

;; Exercises of chapter 1 that have an answer to check.
(define checkable
  (append (range 3 23) (range 24 45)))

(define (source e) (file->string (build-path folder (exercise-file e))))

(test-case "each exercise that can be checked has its program, named after it"
  (check-equal? (map exercise-number (exercises)) checkable)
  (for ([e (in-list (exercises))])
    (check-equal? (exercise-file e) (format "exercise-1-~a.rkt" (exercise-number e)))))

(test-case "each is a module of the readers' language, with tests of a right and a wrong attempt"
  (for ([e (in-list (exercises))])
    (define text (source e))
    (check-true (string-prefix? text "#lang mechanics\n") (exercise-file e))
    (check-true (string-contains? text "\n(module+ test\n") (exercise-file e))))

(test-case "subjects are short, and end without a stop"
  (for ([e (in-list (exercises))])
    (check-true (< (string-length (exercise-subject e)) 60) (exercise-file e))
    (for ([text (list (exercise-subject e) (exercise-checked e) (exercise-how e))])
      (check-false (string-suffix? text ".") (exercise-file e)))))
