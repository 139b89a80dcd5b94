#lang racket/base
;; `raco mechanics new`, `worksheet`, `handout` and `check`: what they write and say, with which
;; status, and what they say to mistakes.

(require json
         mechanics/lang/command/raco
         mechanics/teaching/class/isolation
         racket/file
         racket/list
         racket/string
         xml
         "../../support/checks.rkt")

(define folder (make-temporary-file "mechanics-worksheets~a" 'directory))

;; -> status, and what was printed
(define (command . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out] [current-directory folder])
      (run-command-line arguments)))
  (list status (get-output-string out)))

(define (in-folder name) (build-path folder name))
(define (text name) (file->string (in-folder name)))
(define (write-text name . lines)
  (display-to-file #:exists 'truncate (string-join lines "\n") (in-folder name)))

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
  (check-equal? (command "handout" "first.rkt" "--to" "tex" "-o" "x.tex") '(0 "x.tex\n")))

(test-case "a program becomes the page that show makes"
  (write-text "program.rkt" "#lang mechanics" "(* 2 'x)")
  (check-equal? (command "handout" "program.rkt") '(0 "program.html\n")))

;; ---------------------------------------------------------------------------
;; Checking

(define answers
  '(("L-pendulum" "(lambda ((up t a b)) (+ (* 1/2 'm (square (* 'l b))) (* 'm 'g 'l (cos a))))")
    ("motion" "(lambda (theta t) (- (* 'l (((expt D 2) theta) t)) (* 'g (sin (theta t)))))")
    ("period" "2.0")))

;; What a file prints when it is run, which judges its answers too.
(define (run-file name)
  (define out (open-output-string))
  (parameterize ([current-output-port out] [current-namespace (make-base-namespace)])
    (dynamic-require (in-folder name) #f))
  (get-output-string out))

(define (student-with answers)
  (for/fold ([text (text "first-student.rkt")]) ([a (in-list answers)])
    (string-replace text (format "(define ~a unanswered)" (first a))
                    (format "(define ~a ~a)" (first a) (second a)))))

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

;; ---------------------------------------------------------------------------
;; Files with mistakes

(define (checked name . answers)
  (write-text name (student-with answers))
  (second (command "check" name)))

(test-case "an answer with an unknown name voids no other, and is told once"
  (define said (checked "unbound.rkt" '("period" "(+ perid 1)") (first answers)))
  (check-regexp-match (string-append "^it does not run: line [0-9]+: perid: unbound identifier.*"
                                     "\nwhat could be run of it was judged\n1. L-pendulum: proved ")
                      said)
  (check-regexp-match #rx"4. period: no answer could be had [^\n]*\n   perid is not defined; as a"
                      said)
  (check-equal? (length (regexp-match* #rx"unbound identifier" said)) 1))

(test-case "a definition that fails voids no other"
  (define said (checked "fails.rkt" '("period" "(/ 1 0)") (first answers)))
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
  (define said (checked "open.rkt" (first answers) '("period" "(sqrt 2")))
  (check-regexp-match #rx"^it does not run: line [0-9]+: read-syntax: expected a `[)]`" said)
  (check-regexp-match #rx"\n1. L-pendulum: proved" said)
  (check-regexp-match #rx"\n4. period: no answer could be had [^\n]*\n5. why: no answer" said))

(test-case "an answer under another name is told, and others are judged"
  (write-text "misspelt.rkt"
              (string-replace (student-with (list (first answers)))
                              "(define period unanswered)" "(define perod 2.0)"))
  (define said (second (command "check" "misspelt.rkt")))
  (check-regexp-match
   #rx"^period is not defined; perod is: is that its answer[?]\n1. .*: proved" said)
  (check-regexp-match #rx"^period is not defined; perod is: is that its answer[?]\n1. .*: proved"
                      (run-file "misspelt.rkt")))

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

;; The warning above the list here.
(define (warning-lines)
  (define warning (call-with-isolation 512 10 (lambda (i) (level-warning (isolation-level i)))))
  (if warning (string-append warning "\n\n") ""))

(test-case "a class is listed, with reports for people and for programs"
  (make-directory (in-folder "class"))
  (write-text "class/ann.rkt" (student-with answers))
  (write-text "class/bob.rkt" (string-replace (text "first-student.rkt") "Name: " "Name: Bob B."))
  (check-equal? (command "check" "class" "--worksheet" "first.rkt" "--seconds" "600"
                         "--report" "r.html" "--report" "r.csv" "--report" "r.json"
                         "--gradescope" "results")
                (list 0 (string-append (warning-lines) "ann  3 of 9\nBob B.  0 of 9\n")))
  (check-true (well-formed? (text "r.html")))
  (check-equal? (length (regexp-match* #rx"\r\n" (text "r.csv"))) 3)
  (define result (string->jsexpr (text "results/ann/results.json")))
  (check-equal? (hash-ref result 'score) 3.0)
  (check-equal? (for/list ([t (hash-ref result 'tests)]) (hash-ref t 'status))
                '("passed" "failed" "failed" "passed" "failed")))

;; ---------------------------------------------------------------------------
;; Mistakes

(define (check-refused pattern . arguments)
  (define result (apply command arguments))
  (check-equal? (first result) 2 (format "~s" arguments))
  (check-regexp-match pattern (second result)))

(test-case "mistakes on the line are told in a line"
  (check-refused #rx"^check: for a folder the worksheet is needed" "check" "class")
  (check-refused #rx"^check: there is no such file" "check" "no-such.rkt")
  (check-refused #rx"^check: the file holds no worksheet, and none is given" "check" "program.rkt")
  (check-refused #rx"^check: there is no such file" "check" "class" "--worksheet" "no-such.rkt")
  (check-refused #rx"^check: it is no worksheet" "check" "class" "--worksheet" "program.rkt")
  (check-refused #rx"^check: a report is a file that ends with" "check" "class" "--worksheet"
                 "first.rkt" "--report" "r.pdf")
  (check-refused #rx"^check: --seconds takes" "check" "class" "--seconds" "soon")
  (check-refused #rx"^worksheet: there is no such file" "worksheet" "no-such.rkt")
  (for ([command '("worksheet" "handout")])
    (define (check-told pattern file)
      (check-refused (regexp (string-append "^" command ": " pattern)) command file))
    (check-told "there is no such file\n  file: elsewhere/a.rkt\n  there is no such folder: /"
                "elsewhere/a.rkt")
    (check-told "there is no such file\n  file: /zz/a.rkt\n  there is no such folder: /zz/"
                "/zz/a.rkt")
    (check-told "there is no such file\n  file: class/zz.rkt\n  in the folder .*class/\n  the progr"
                "class/zz.rkt")
    (check-told "there is no such file\n  file: ~/a.rkt\n  ~ is the home folder to a shell alone"
                "~/a.rkt")
    (check-told "this is a folder; the programs in it: .*\n  folder: class" "class")
    (check-told "which file[?]" ""))
  (check-refused #rx"^worksheet: it is no worksheet" "worksheet" "program.rkt")
  (check-refused #rx"^handout: it can be made --to html or" "handout" "first.rkt" "--to" "pdf")
  (make-directory (in-folder "nobody"))
  (check-refused #rx"^check: there is no submission" "check" "nobody" "--worksheet" "first.rkt"))

(test-case "a name without .rkt, or misspelt, is told which was meant"
  (for ([typed '("first" "frist.rkt")])
    (define pattern (format "there is no such file; did you mean first.rkt[?]\n  file: ~a" typed))
    (for ([c '("worksheet" "handout" "check")]) (check-refused pattern c typed))
    (check-refused pattern "check" "class" "--worksheet" typed)))

(test-case "what is written has the name of what it is"
  (check-refused #rx"^worksheet: it writes a file that ends with .rkt\n  given: x.pdf\n  for PDF: "
                 "worksheet" "first.rkt" "-o" "x.pdf")
  (check-refused #rx"^handout: it writes a file that ends with .html\n  given: x.pdf\n  for PDF: "
                 "handout" "first.rkt" "-o" "x.pdf")
  (check-refused #rx"^handout: it writes a file that ends with .html\n  given: x.tex\n$"
                 "handout" "first.rkt" "-o" "x.tex" "--to" "html")
  (check-refused #rx"^show: it writes .* .html\n  given: x.pdf\n  for PDF: "
                 "show" "program.rkt" "-o" "x.pdf")
  (check-refused #rx"^tex: it writes .* .tex\n  given: x.pdf\n  for PDF: "
                 "tex" "program.rkt" "-o" "x.pdf")
  (check-equal? (command "handout" "first.rkt" "-o" "y.tex") '(0 "y.tex\n")))

(test-case "an envelope that was changed is told"
  (write-text "torn.rkt" (regexp-replace #rx"\n \"...." (text "first-student.rkt") "\n \"AAAA"))
  (check-refused #rx"the lines that hold its exercises were changed" "check" "torn.rkt"))

;; Mistakes in a worksheet are told when it is made.  Each is a module of its own.
(define (check-worksheet pattern . lines)
  (define name (format "~a.rkt" (gensym 'bad)))
  (apply write-text name "#lang mechanics/worksheet" lines)
  (check-refused pattern "worksheet" name))

(define title "(title \"Bad\")")

(test-case "a worksheet with a mistake is refused"
  (check-worksheet #rx"^worksheet: it has no title" "(exercise a number \"?\" (key 1))")
  (check-worksheet #rx"^worksheet: it has no exercise" title)
  (check-worksheet #rx"^worksheet: two exercises are called a" title
                   "(exercise a number \"?\" (key 1))" "(exercise a number \"?\" (key 2))")
  (check-worksheet #rx"^a: there is no kind of exercise called numbr; did you mean number[?]" title
                   "(exercise a numbr \"?\" (key 1))")
  (check-worksheet #rx":3:23: a: there is no clause called keys; did you mean key[?]\n  there are: "
                   title "(exercise a number \"?\" (keys 1))")
  (check-worksheet #rx":3:19: a: the question is missing, a text behind the kind" title
                   "(exercise a number (key (sqrt k)))")
  (check-worksheet #rx"a: the clause `key` takes one value\n  at: [(]key[)]" title
                   "(exercise a number \"?\" (key))")
  (check-worksheet #rx"a: the clause `coordinates` takes names, without quotes" title
                   "(exercise a Lagrangian \"?\" (coordinates 'x) (key square))")
  (check-worksheet #rx"a: the clause `slip` takes a wrong answer, and a text in quotation marks"
                   title "(exercise a number \"?\" (key 1) (slip 2 no it is not #:credit 1/2))")
  (check-worksheet #rx"a: the clause `no-practice` takes nothing" title
                   "(exercise a number \"?\" (key 1) (no-practice #t))")
  (check-worksheet #rx"a: a clause is a list that begins with its name" title
                   "(exercise a number \"?\" key 1)")
  (check-worksheet #rx"a: the clause `slip` takes no keyword #:credits" title
                   "(exercise a number \"?\" (key 1) (slip 2 \"no\" #:credits 1/2))")
  (check-worksheet #rx"a: a text stands in straight quotation marks" title
                   "(exercise a number “How many?” (key 1))")
  (check-worksheet #rx"title: a title is a text, and says perhaps when it is due"
                   "(title \"Bad\" \"Friday\")" "(exercise a number \"?\" (key 1))")
  (check-worksheet #rx"^title: expected a text, in quotation marks\n  given: 5" "(title 5)")
  (check-worksheet #rx"^title: expected a text, .*given: 4" "(title \"Bad\" #:due 4)")
  (check-worksheet #rx"^text: expected a text, .*given: x" title "(text \"See \" 'x)")
  (check-worksheet #rx"^a: it has no key" title "(exercise a number \"?\")")
  (check-worksheet #rx"^a: the clause `key` stands there twice" title
                   "(exercise a number \"?\" (key 1) (key 2))")
  (check-worksheet #rx"^a: it needs the names of the coordinates" title
                   "(exercise a Lagrangian \"?\" (key square))")
  (check-worksheet #rx"^a: the clause `points` takes a number" title
                   "(exercise a number \"?\" (key 1) (points 'x))")
  (check-worksheet #rx"an exercise has a name, a kind and a question" title "(exercise a)"))

(test-case "a wrong key is refused, with its verdict, and no slip is seen in it"
  (check-worksheet #rx"^a: its own key is refuted\na: refuted.*zero if: " title
                   "(define (L (up t x v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square x))))"
                   "(exercise a conserved \"?\" (coordinates x) (of L) (key velocity))")
  (check-worksheet
   #rx"^a: its own key is refuted\na: refuted [(]0 of 1 point[)]\n   refuted: the res"
                   title "(define (L (up t x v)) (- (square v) (square x)))"
                   "(exercise a conserved \"?\" (coordinates x) (of L) (key L))")
  (check-worksheet #rx"^a: its own key is refuted\na: refuted" title
                   "(define (L (up t x v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square x))))"
                   "(exercise a equations \"?\" (coordinates x) (of L)"
                   "  (key (lambda (x t) (- (* 'm (((expt D 2) x) t)) (* 'k (x t))))))")
  (check-worksheet #rx"^a: what is given as a slip is a right answer" title
                   "(exercise a expression \"?\" (key (sin (* 2 'x)))"
                   "  (slip (* 2 (sin 'x) (cos 'x)) \"no\"))"))

(delete-directory/files folder)
