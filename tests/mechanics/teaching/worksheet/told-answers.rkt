#lang racket/base
;; Words to students about their answers: a judgment with its evidence, and the hints that are
;; due; and the record of wrong answers.

(require racket/port
         (prefix-in m: mechanics)
         mechanics/teaching/worksheet/check-answers
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         "../../support/checks.rkt" "../../support/folder.rkt")

(define twice
  (make-exercise 'twice 'expression "?"
                 (list (list 'key (m:* 2 'x)) '(hint "double it" #:after 1))))
(define count (make-exercise 'count 'expression "?" '((key 2))))
(define reason (make-exercise 'reason 'reason "?" '()))

(define (told file . answers)
  (define all (map judged-answer-to (list twice count reason) answers))
  (with-output-to-string (lambda () (tell-judgments-of-file all file))))

(test-case "a wrong answer has its evidence and a hint, a right one has none"
  (define text (told #f (m:* -2 'x) 3 "because"))
  (check-regexp-match #rx"1[.].*the sign is the opposite.*it fails at x = .*double it.*\n2[.]" text)
  (check-false (regexp-match? #rx"2[.].*it fails at" text) text)
  (check-false (regexp-match? #rx"it fails|double it" (told #f (m:+ 'x 'x) 2 "because"))))

(test-case "a reason is a text, and kept"
  (check-equal? (judged-status (judged-answer-to reason "because")) 'kept)
  (check-equal? (judged-status (judged-answer-to reason 5)) 'failed))

(test-case "wrong answers are kept beside the file, where there are some"
  (with-folder (folder)
    (define file (build-path folder "mine.rkt"))
    (void (told file (m:* 2 'x) 2 "because"))
    (check-equal? (directory-list folder) '())
    (void (told file (m:* 3 'x) 2 "because"))
    (check-equal? (map path->string (directory-list folder)) '("mine.tries"))))
