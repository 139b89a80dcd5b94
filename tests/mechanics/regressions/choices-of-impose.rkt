#lang racket/base
;; impose divided by a factor of both sides, or took one of two roots, without a word; only
;; verify-again told.

(require "../support/checks.rkt" "../support/run-text.rkt")

(test-case "a choice is told once in a session, beside the result"
  (define-values (output errors)
    (session '("-I" "mechanics")
             "(impose 'y '(= (* x y) (* x z)))"
             "(impose (* 2 'y) '(= (* x y) (* x z)))"
             "((impose (lambda (t) (* 'a t)) '(= (expt a 2) 4)) 3)"
             "(impose 'k '(= k 3))"))
  (check-equal? output '("z" "(* 2 z)" "6" "3"))
  (check-equal? errors
                (lines "; impose: (* x y) = (* x z), with x not 0"
                       "; impose: (expt a 2) = 4, with a = 2")))
