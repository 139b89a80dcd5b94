#lang racket/base
;; The programs for the exercises: which there are, what each says of itself, and how what it
;; prints looks.  What it should be is tested in them.

(require (only-in mechanics/book)
         (only-in mechanics/plot)
         racket/file
         racket/list
         racket/runtime-path
         racket/string
         rackunit
         "../../scribblings/mechanics/exercises.rkt")

(define-runtime-path folder "../../examples/mechanics/exercises")

;; Exercises that have an answer to check, by chapter.
(define checkable
  (list (cons 1 (append (range 3 23) (range 24 45)))
        (cons 2 '(1 2 3 4 5 6 8 9 10 11 12 14 15 16 17 18 19 20 21))
        (cons 3 (range 1 17))
        (cons 4 (range 1 11))
        (cons 5 (range 1 22))
        (cons 6 (range 1 13))
        (cons 7 (range 1 6))))

(define all (append-map exercises (map car checkable)))

(define (source e) (file->string (build-path folder (exercise-file e))))

(test-case "each exercise that can be checked has its program, named after it"
  (for ([chapter (in-list checkable)])
    (check-equal? (map exercise-number (exercises (car chapter))) (cdr chapter)))
  (for ([e (in-list all)])
    (check-equal? (exercise-file e)
                  (format "exercise-~a-~a.rkt" (exercise-chapter e) (exercise-number e)))))

(test-case "each is a module of the readers' language, with tests of a right and a wrong attempt"
  (for ([e (in-list all)])
    (define text (source e))
    (check-true (string-prefix? text "#lang mechanics\n") (exercise-file e))
    (check-true (string-contains? text "\n(module+ test\n") (exercise-file e))))

(test-case "subjects are short, and end without a stop"
  (for ([e (in-list all)])
    (check-true (< (string-length (exercise-subject e)) 60) (exercise-file e))
    (for ([text (list (exercise-subject e) (exercise-checked e) (exercise-how e))])
      (check-false (string-suffix? text ".") (exercise-file e)))))

;; ---------------------------------------------------------------------------
;; What they print

(define-namespace-anchor here)

;; In a namespace where the library is loaded already, and no program.
(define (printed e)
  (define out (open-output-string))
  (define namespace (make-base-empty-namespace))
  (for ([library (in-list '(mechanics mechanics/book mechanics/plot))])
    (namespace-attach-module (namespace-anchor->empty-namespace here) library namespace))
  (parameterize ([current-namespace namespace] [current-output-port out])
    (dynamic-require (build-path folder (exercise-file e)) #f))
  (get-output-string out))

(test-case "what they print fits a terminal, and nothing opaque is in it"
  (for ([e (in-list all)])
    (define text (printed e))
    (check-true (> (string-length text) 10) (exercise-file e))
    (check-false (string-contains? text "#<") text)
    (for ([line (in-list (string-split text "\n"))])
      (check-true (< (string-length line) 80) (format "~a: ~a" (exercise-file e) line)))))
