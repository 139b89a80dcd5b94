#lang racket/base
;; Errors of a program, told with the reader's own lines and without those of libraries.

(require racket/list
         "../../support/checks.rkt" "../../support/errors-of.rkt")

(test-case "the form that was evaluated is told after the message, with its line"
  (check-equal? (errors-of "#lang mechanics" "(define a 1)" "" "(up 1 (car a))")
                '("car: contract violation" "  expected: pair?" "  given: 1"
                  "  in: my.rkt, line 4: (up 1 (car a))")))

(test-case "of a definition too; a long form is joined and cut"
  (check-equal? (last (errors-of "#lang mechanics" "(define a" "  (list 1" "    (car 2)))"))
                "  in: my.rkt, line 2: (define a (list 1 (car 2)))")
  (check-equal? (last (errors-of "#lang mechanics"
                                 "(define something-with-a-long-name"
                                 "  (list 'one-more 'and-another" "    (car 2)))" "(define b 2)"))
                (string-append "  in: my.rkt, line 2: (define something-with-a-long-name "
                               "(list 'one-more 'and-anot ...")))

(test-case "functions of the program are named with their lines, those of libraries are not"
  (define told
    (errors-of "#lang mechanics"
               "(define (twice f)"
               "  (list (f 1) (f 2)))"
               "(define (first-of x) (+ 1 (car x)))"
               "(up (twice first-of) 1)"))
  (check-equal? (fourth told) "  in: my.rkt, line 5: (up (twice first-of) 1)")
  (check-regexp-match #rx"^  within: .*twice \\(my.rkt, line 2\\)$" (fifth told))
  (check-equal? (length told) 5))

(test-case "an error in the library is told with the program's line alone"
  (define told (errors-of "#lang mechanics" "(Lagrange-equations 3)"))
  (check-equal? (last told) "  in: my.rkt, line 2: (Lagrange-equations 3)")
  (check-false (ormap (lambda (line) (regexp-match? #rx"context|collects|mechanics/" line)) told)))

(test-case "a form that a macro makes is told by what was written"
  (check-equal? (last (errors-of "#lang mechanics"
                                 "(define-syntax-rule (both a b) (list a b))"
                                 "(both 1 (car 2))"))
                "  in: my.rkt, line 3: (both 1 (car 2))"))

(test-case "a name that is replaced leaves the line of its second definition"
  (check-equal? (last (errors-of "#lang mechanics" "(define a 1)" "(define a (car 3))"))
                "  in: my.rkt, line 3: (define a (car 3))"))

(test-case "what cannot be expanded is told as ever"
  (define told (errors-of "#lang mechanics" "(define a 1)" "(if a)"))
  (check-regexp-match #rx"my.rkt:3:0: if: bad syntax" (first told))
  (check-false (ormap (lambda (line) (regexp-match? #rx"context" line)) told)))
