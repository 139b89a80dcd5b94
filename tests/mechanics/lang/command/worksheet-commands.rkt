#lang racket/base
;; `raco mechanics new`, `worksheet`, `handout` and `check`: what they write and say, with which
;; status.

(require json
         racket/list
         racket/string
         xml
         "../../support/checks.rkt" "../../support/worksheet-folder.rkt")

(define (well-formed? page)
  (xexpr? (xml->xexpr (document-element
                       (read-xml (open-input-string (string-replace page "<!DOCTYPE html>" "")))))))

;; ---------------------------------------------------------------------------
;; From the template to a student's file

(test-case "a template is written, and none is overwritten"
  (check-equal? (command "new" "first") '(0 "first.rkt\n"))
  (check-regexp-match #rx"^#lang mechanics/worksheet\n" (text "first.rkt"))
  (check-equal? (first (command "new" "first.rkt")) 2))

(test-case "a worksheet becomes the student's file and a page, in HTML and TeX"
  (check-equal? (command "worksheet" "first.rkt")
                '(0
                  "first-student.rkt\nfirst-student.ipynb\nfirst-student.html\nfirst-student.tex\n"))
  (define student (text "first-student.rkt"))
  (check-true (string-contains? student "(define period unanswered)"))
  (check-true (string-contains? student "\n(define ((T m l) (up t theta thetadot))\n  (* 1/2")
              "what is given stands there as it is written")
  (check-false (string-contains? student "(define L ") "what is the teacher's does not")
  (check-true (well-formed? (text "first-student.html")))
  (check-true (string-contains? (text "first-student.html") "<math"))
  (check-false (string-contains? (text "first-student.html") "Key:"))
  (check-true (string-contains? (text "first-student.tex") "\\section*{2. motion}")))

(test-case "the teacher's page has the answers"
  (check-equal? (command "handout" "first.rkt" "--answers") '(0 "first-answers.html\n"))
  (check-true (string-contains? (text "first-answers.html") "Key:"))
  (check-equal? (command "handout" "first.rkt" "--answers" "--to" "tex" "-o" "x.tex")
                '(0 "x.tex\n"))
  (check-true (string-contains? (text "x.tex") "\\ddot{\\theta}(t)")
              "keys are drawn as results are"))

(test-case "a program becomes the page that show makes"
  (write-text "program.rkt" "#lang mechanics" "(* 2 'x)")
  (check-equal? (command "handout" "program.rkt") '(0 "program.html\n")))

;; ---------------------------------------------------------------------------
;; Checking

(define answers
  '(("L-pendulum" "(lambda ((up t a b)) (+ (* 1/2 'm (square (* 'l b))) (* 'm 'g 'l (cos a))))")
    ("motion" "(lambda (theta t) (- (* 'l (((expt D 2) theta) t)) (* 'g (sin (theta t)))))")
    ("period" "2.0")))

(define (student-with answers) (answered (text "first-student.rkt") answers))

(test-case "an empty file is told to be empty"
  (define result (command "check" "first-student.rkt"))
  (check-equal? (first result) 1)
  (check-regexp-match #rx"^1. L-pendulum: not answered \\(0 of 2 points\\)\n" (second result))
  (check-regexp-match #rx"\n0 of 9 points.\n$" (second result)))

(test-case "answers are judged, with the hint that belongs to a wrong one"
  (write-text "ann.rkt" (student-with answers))
  (define result (command "check" "ann.rkt"))
  (check-equal? (first result) 1)
  (check-regexp-match (string-append
                       "^1. L-pendulum: proved \\(2 of 2 points\\)\n"
                       "2. motion: refuted \\(0 of 3 points\\)\n"
                       "   the sign is the opposite\n   it fails at [^\n]*\n"
                       "   hint: Lagrange's equations")
                      (second result)))

(test-case "a hint may wait for the second wrong answer; the same one again is none"
  (write-text "late.rkt" "#lang mechanics/worksheet" "(title \"Late\")"
              "(exercise two number \"?\" (key 2) (hint \"soon\") (hint \"late\" #:after 2))")
  (command "worksheet" "late.rkt")
  (define (hints-for answer check)
    (write-text "tried.rkt" (string-replace (text "late-student.rkt") "two unanswered)"
                                            (format "two ~a)" answer)))
    (regexp-match* #rx"hint: ([a-z]+)" (check "tried.rkt") #:match-select cadr))
  (define (checked name) (second (command "check" name)))
  (check-equal? (map hints-for '(5 5 7 5 2) (list checked run-file run-file checked run-file))
                '(("soon") ("soon") ("soon" "late") ("soon" "late") ())))

(test-case "all that is right makes the status 0"
  (write-text "small.rkt" "#lang mechanics/worksheet" "(title \"Small\")"
              "(exercise two number \"What is one and one?\" (key 2))")
  (command "worksheet" "small.rkt")
  (write-text "done.rkt" (string-replace (text "small-student.rkt") "(define two unanswered)"
                                         "(define two 2)"))
  (check-equal? (command "check" "done.rkt") '(0 "1. two: right (1 of 1 point)\n1 of 1 point.\n"))
  (define as-JSON (command "check" "done.rkt" "--json" "--worksheet" "small.rkt"))
  (check-equal? (first as-JSON) 0)
  (check-equal? (hash-ref (first (hash-ref (string->jsexpr (second as-JSON)) 'submissions)) 'points)
                1.0))

(test-case "a class is listed, with reports for people and for programs"
  (make-directory (in-folder "class"))
  (write-text "class/ann.rkt" (student-with answers))
  (write-text "class/bob.rkt" (string-replace (text "first-student.rkt") "Name: " "Name: Bob B."))
  (check-equal? (command "check" "class" "--worksheet" "first.rkt" "--seconds" "600"
                         "--report" "r.html" "--report" "r.csv" "--report" "r.json"
                         "--gradescope" "results")
                '(0 "ann  3 of 9\nBob B.  0 of 9\n"))
  (check-true (well-formed? (text "r.html")))
  (check-equal? (length (regexp-match* #rx"\r\n" (text "r.csv"))) 3)
  (define result (string->jsexpr (text "results/ann/results.json")))
  (check-equal? (hash-ref result 'score) 3.0)
  (check-equal? (for/list ([t (hash-ref result 'tests)]) (hash-ref t 'status))
                '("passed" "failed" "failed" "passed" "failed")))

(delete-folder)
