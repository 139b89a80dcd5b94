#lang racket/base
;; Mistakes on the line of `raco mechanics new`, `worksheet`, `handout` and `check`, and in
;; worksheets.

(require "../../support/checks.rkt" "../../support/worksheet-folder.rkt")

(void (command "new" "first"))
(write-text "program.rkt" "#lang mechanics" "(* 2 'x)")
(make-directory (in-folder "class"))
(write-text "class/ann.rkt" "#lang mechanics")

(test-case "mistakes on the line are told in a line"
  (check-refused #rx"^check: for a folder the worksheet is needed" "check" "class")
  (check-refused #rx"^check: there is no such file" "check" "no-such.rkt")
  (check-refused #rx"^check: the file holds no worksheet, and none is given" "check" "program.rkt")
  (check-refused #rx"^check: there is no such file" "check" "class" "--worksheet" "no-such.rkt")
  (check-refused #rx"^check: it is no worksheet" "check" "class" "--worksheet" "program.rkt")
  (check-refused #rx"^check: a report is a file that ends with" "check" "class" "--worksheet"
                 "first.rkt" "--report" "r.pdf")
  (check-refused #rx"^check: there is no such folder" "check" "class" "--worksheet" "first.rkt"
                 "--report" "no-such/r.csv")
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
  (check-refused #rx"^check: there is no submission" "check" "nobody" "--worksheet" "first.rkt"
                 "--report" "r.csv"))

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
  (check-worksheet #rx"a: the clause `credit` takes shares of the points, as in [(]credit #:sign"
                   title "(exercise a number \"?\" (key 1) (credit 1/2))")
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

(delete-folder)
