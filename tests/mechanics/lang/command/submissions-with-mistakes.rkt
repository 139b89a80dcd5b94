#lang racket/base
;; `raco mechanics check` of files with mistakes: each is told with its line, and costs no more than
;; its own answer.

(require racket/list
         racket/string
         "../../support/checks.rkt" "../../support/worksheet-folder.rkt")

(void (command "new" "first"))
(void (command "worksheet" "first.rkt"))

(define right
  '("L-pendulum" "(lambda ((up t a b)) (+ (* 1/2 'm (square (* 'l b))) (* 'm 'g 'l (cos a))))"))

(define (student-with answers) (answered (text "first-student.rkt") answers))

(define (checked name . answers)
  (write-text name (student-with answers))
  (second (command "check" name)))

(test-case "an answer with an unknown name voids no other, and is told once"
  (define said (checked "unbound.rkt" '("period" "(+ perid 1)") right))
  (check-regexp-match (string-append "^it does not run: line [0-9]+: perid: unbound identifier.*"
                                     "\nwhat could be run of it was judged\n1. L-pendulum: proved ")
                      said)
  (check-regexp-match #rx"4. period: no answer could be had [^\n]*\n   perid is not defined; as a"
                      said)
  (check-equal? (length (regexp-match* #rx"unbound identifier" said)) 1))

(test-case "a definition that fails voids no other"
  (define said (checked "fails.rkt" '("period" "(/ 1 0)") right))
  (check-regexp-match
   #rx"^it does not run: line [0-9]+: /: division by zero\n.*1. L-pendulum: proved" said)
  (check-regexp-match #rx"4. period: no answer could be had [^\n]*\n   /: division by zero" said))

(test-case "habits of other programs are told, with the line"
  (define said
    (checked "habits.rkt" '("L-pendulum" "1,5") '("motion" "(* 2 1,5)") '("period" "[1 2]")))
  (check-regexp-match #px"line \\d+: define: L-pendulum has one value, and a decimal has a point"
                      said)
  (check-regexp-match #px"line \\d+: unquote: [^\n]*\n[^\n]*\n  +no comma separates arguments, and"
                      said)
  (check-regexp-match #px"application: brackets are parentheses here" said)
  (check-regexp-match #px"line \\d+: [*][*]: unbound identifier; powers are [(]expt x 2[)]"
                      (checked "power.rkt" '("period" "(** 'x 2)"))))

(test-case "an answer may be a text, and what was read is told"
  (define said
    (checked "text.rkt" '("motion" "\"l theta'' + g sin theta = 0\"") '("period" "\"2.0 s\"")))
  (check-regexp-match #rx"2. motion: proved [^\n]*\n   read as l θ̈ [+] g sin θ\n" said)
  (check-regexp-match #rx"4. period: right [^\n]*\n   read as 2.0\n" said))

(test-case "the student's file tells the names of constants, and text stands before its exercise"
  (define student (text "first-student.rkt"))
  (check-regexp-match #rx"in quotation marks. Names in it: m, l, g; the coordinate theta, its"
                      student)
  (write-text "passage.rkt" "#lang mechanics/worksheet" "(title \"P\")" "(text \"Before one.\")"
              "(exercise one number \"?\" (key 1))" "(text \"Before two.\")"
              "(exercise two number \"?\" (key 2))")
  (command "worksheet" "passage.rkt")
  (for ([file '("passage-student.rkt" "passage-student.html" "passage-student.ipynb")])
    (check-regexp-match #rx"Before one.*one.*Before two.*two" (text file) file)))

(test-case "what stands before a form that cannot be read is judged"
  (define said (checked "open.rkt" right '("period" "(sqrt 2")))
  (check-regexp-match #rx"^it does not run: line [0-9]+: read-syntax: expected a `[)]`" said)
  (check-regexp-match #rx"\n1. L-pendulum: proved" said)
  (check-regexp-match #rx"\n4. period: no answer could be had [^\n]*\n5. why: no answer" said))

(test-case "an answer under another name is told, and others are judged"
  (write-text "misspelt.rkt"
              (string-replace (student-with (list right))
                              "(define period unanswered)" "(define perod 2.0)"))
  (define said (second (command "check" "misspelt.rkt")))
  (check-regexp-match
   #rx"^period is not defined; perod is: is that its answer[?]\n1. .*: proved" said)
  (check-regexp-match #rx"^period is not defined; perod is: is that its answer[?]\n1. .*: proved"
                      (run-file "misspelt.rkt")))

(test-case "an envelope that was changed is told"
  (write-text "torn.rkt" (regexp-replace #rx"\n \"...." (text "first-student.rkt") "\n \"AAAA"))
  (check-refused #rx"the lines that hold its exercises were changed" "check" "torn.rkt"))

(delete-folder)
