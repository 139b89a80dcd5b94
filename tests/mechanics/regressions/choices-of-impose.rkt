#lang racket/base
;; impose divided by a factor of both sides, or took one of two roots, without a word; only
;; verify-again told.  It took the root that is not negative where a negative one was declared.

(require "../support/checks.rkt" "../support/run-text.rkt")

(define ask (open-prompt "-I" "mechanics"))

(test-case "a choice is told once in a session, beside the result"
  (define-values (output errors)
    (ask "(impose 'y '(= (* x y) (* x z)))"
         "(impose (* 2 'y) '(= (* x y) (* x z)))"
         "((impose (lambda (t) (* 'a t)) '(= (expt a 2) 4)) 3)"
         "(impose 'k '(= k 3))"))
  (check-equal? output '("z" "(* 2 z)" "6" "3"))
  (check-equal? errors
                (lines "; impose: (* x y) = (* x z), with x not 0"
                       "; impose: (expt a 2) = 4, with a = 2")))

(test-case "a sign that is declared decides, and nothing is chosen"
  (define-values (output errors)
    (ask "(assume '(< x 0) '(> y 0))"
         "(impose (cube 'x) '(= (expt x 2) 4))"
         "(impose 'x '(= (* 4 (expt x 2)) (expt y 2)))"
         "(impose (up 'x 'y) '((= (expt x 2) 9) (= (expt y 2) 16)))"
         "(impose 'x '(= x (- (* 2 y))))"))
  (check-equal? output '("-8" "(* -1/2 y)" "(up -3 4)" "(* -2 y)"))
  (check-equal? errors (lines)))
