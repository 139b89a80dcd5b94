#lang racket/base
;; The autograder of a worksheet, in a folder with Gradescope's places; the library is that of here,
;; compiled.

(require compiler/find-exe
         file/unzip
         json
         racket/file
         racket/path
         racket/system
         "../../support/checks.rkt" "../../support/worksheet-folder.rkt")

(write-text "w.rkt" "#lang mechanics/worksheet" "(title \"Numbers\")"
            "(deadline \"2026-11-20 12:00 Z\" #:per-day 1/4)" "(credit #:sign 1/2)"
            "(parameters #:seed 7 [l 1 3/2 2 5/2])"
            "(exercise double number (format \"Twice ~a?\" l) (key (* 2 l)) (points 2))"
            "(exercise root expression \"?\" (key (sqrt (/ 'g l))) (points 2))"
            "(exercise why reason \"Why?\" (points 4))")
(write-text "list.csv" "Full name,Email address,Handed in,Extension"
            "Cem,cem@uni.edu,2026-11-22 11:00 Z,2" "Dan,dan@uni.edu,,")
(void (command "worksheet" "w.rkt" "--class" "list.csv"))

(test-case "an autograder of a worksheet that is none, or not whole, is refused"
  (check-refused #rx"^autograder: it is no worksheet" "autograder" "w-students/cem@uni.edu.rkt")
  (check-refused #rx"^autograder: it writes a file that ends with .zip" "autograder" "w.rkt" "-o"
                 "a.tar")
  (write-text "mine.rkt" "#lang mechanics" "(provide two)" "(define two 2)")
  (write-text "parts.rkt" "#lang mechanics/worksheet" "(require \"mine.rkt\")" "(title \"Parts\")"
              "(exercise a number \"?\" (key two))")
  (check-refused #rx"^autograder: the worksheet requires other files; put .*\n  files: mine.rkt\n"
                 "autograder" "parts.rkt"))

(define root (in-folder "autograder"))
(define (in-root . parts) (apply build-path root parts))

(define (run-autograder)
  (parameterize ([current-environment-variables
                  (environment-variables-copy (current-environment-variables))])
    (putenv "AUTOGRADER" (path->string root))
    (putenv "PATH" (string-append (path->string (path-only (find-exe))) ":" (getenv "PATH")))
    (system* "/bin/sh" (in-root "source" "run_autograder"))))

(define (results) (call-with-input-file (in-root "results" "results.json") read-json))

(test-case "the autograder's archive is unpacked, and grades what it finds"
  (check-equal? (command "autograder" "w.rkt") '(0 "autograder.zip\n"))
  (make-directory* (in-root "submission"))
  (make-directory (in-root "source"))
  (parameterize ([current-directory (in-root "source")]) (unzip (in-folder "autograder.zip")))
  (check-equal? (map path->string (directory-list (in-root "source")))
                '("mechanics" "run_autograder" "setup.sh" "worksheet.rkt"))
  (delete-directory/files (in-root "source" "mechanics"))
  (make-file-or-directory-link (collection-path "mechanics") (in-root "source" "mechanics"))
  (display-to-file
   (jsexpr->string (hasheq 'created_at "2026-11-20T13:00:00.000000+01:00"
                           'users (list (hasheq 'email "Cem@uni.edu" 'name "Cem" 'id 1))))
   (in-root "submission_metadata.json"))
  (write-text "autograder/submission/mine.rkt"
              (answered (text "w-students/cem@uni.edu.rkt")
                        '(("double" "(* 2 l)") ("root" "(- (sqrt (/ 'g l)))"))))
  (check-true (run-autograder))
  (check-equal? (hash-ref (results) 'score) 3.0)
  (check-equal? (map (lambda (t) (hash-ref t 'score)) (hash-ref (results) 'tests)) '(2.0 1.0 0.0)))

(test-case "nothing handed in, and a failure of the autograder itself, are results, too"
  (delete-file (in-root "submission" "mine.rkt"))
  (check-true (run-autograder))
  (check-equal? (hash-ref (results) 'score) 0.0)
  (check-regexp-match #rx"no file that ends with .rkt or .ipynb" (hash-ref (results) 'output))
  (delete-file (in-root "submission_metadata.json"))
  (check-false (run-autograder))
  (check-regexp-match #rx"^It could not be graded; tell your teacher: "
                      (hash-ref (results) 'output)))

(delete-folder)
