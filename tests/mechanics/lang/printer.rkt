#lang racket/base
;; The part of a long text that fits a screen.

(require mechanics/lang/printer
         "../support/checks.rkt"
         "../support/run-text.rkt")

(define-check (check-screen text rows columns expected)
  (define got (call-with-values (lambda () (first-screen text rows columns)) list))
  (with-check-info (['got got] ['expected expected])
    (unless (equal? got expected) (fail-check))))

(test-case "what fits stays as it is"
  (check-screen "" 3 10 '("" #f 0))
  (check-screen "a\n" 3 10 '("a\n" #f 0))
  (check-screen "a" 3 10 '("a" #f 0))
  (check-screen (lines "a" "" "c") 3 10 (list (lines "a" "" "c") #f 0)))

(test-case "of what does not, the first rows are shown, and the others kept"
  (check-screen (lines "a" "b" "c" "" "e") 3 10
                (list (lines "a" "b" "c") (lines "" "e") 2)))

(test-case "a line takes the rows that the terminal needs for it"
  (check-screen (lines "0123456789" "b") 2 10 (list (lines "0123456789" "b") #f 0))
  (check-screen (lines "0123456789x" "b") 2 10 (list (lines "0123456789" "x") (lines "b") 1))
  (check-screen "012345678901234567890" 2 10 (list (lines "0123456789" "0123456789") "0\n" 1)))
