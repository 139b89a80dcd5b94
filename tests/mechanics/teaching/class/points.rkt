#lang racket/base
;; Points that a teacher enters in a table: they are kept, merged, and told where they are
;; nobody's.

(require mechanics/teaching/class/class-list
         mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
         mechanics/teaching/class/entered-points
         mechanics/teaching/class/grade
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         racket/string
         "../../support/checks.rkt" "../../support/class-reports.rkt"
         "../../support/folder.rkt" "../../support/messages.rkt")

(define w
  (make-worksheet "Points" #f "points"
                  (list (make-exercise 'two 'number "?" '((key 2)))
                        (make-exercise 'why 'reason "?" '((points 3))))))

(define ann (participant-of "ann@uni.edu" "Ann, of \"A\"" #f))
(define (report [why "because"])
  (report-of w (list ann)
             (list "ann@uni.edu" "Ann" '(answer 2) (list 'text why))
             '("=b" "Bob" (answer 3) (text "-it is so,\nand \"thus\""))
             '("c" "Cem" (answer 2) (unanswered))))

;; The table as it is, with the lines edited -> entries
(define (read-table-text text)
  (with-folder (folder)
    (parameterize ([current-directory folder])
      (display-to-file text "points.csv")
      (read-entered-points 'check "points.csv"))))

(define empty (entered-points->CSV (report) '()))
(define (merged text [r (report)])
  (with-entered-points 'check "points.csv" r (read-table-text text)))
(define (points-in r) (map graded-points (class-report-graded r)))

(test-case "the table has a row for each answer that is left to a person, with the answer"
  (check-equal? empty
                (string-append
                 "\uFEFF\"submission\",\"name\",\"exercise\",\"answer\",\"of\",\"points\",\"comment\"\r\n"
                 "\"ann@uni.edu\",\"Ann, of \"\"A\"\"\",\"why\",\"because\",\"3\",\"\",\"\"\r\n"
                 "\"'=b\",\"Bob\",\"why\",\"'-it is so, and \"\"thus\"\"\",\"3\",\"\",\"\"\r\n"))
  (check-equal? (points-in (merged empty)) '(1 0 1)))

;; As if typed into the table
(define (typed points comment [table empty] [at "because\",\"3\","])
  (string-replace table (string-append at "\"\",\"\"")
                  (format "~a\"~a\",\"~a\"" at points comment)))

(test-case "what is typed there is merged into all reports"
  (define r (merged (typed "2,5" "good, but short")))
  (check-equal? (points-in r) '(7/2 0 1))
  (check-equal? (class-report-remarks r) '())
  (check-equal? (map graded-open (class-report-graded r)) '(0 1 0))
  (check-regexp-match #rx"marked by the teacher \\(2.5 of 3 points\\); good, but short"
                      (class->Moodle r))
  (check-regexp-match #rx"\"why points\".*\"marked\",\"2.5\"" (class->csv r))
  (check-regexp-match #rx"✎ 2.5" (class->page r))
  (check-regexp-match #rx"good, but short" (graded->Gradescope (car (class-report-graded r))))
  (check-false (regexp-match? #rx"\"status\":\"[a-z]+\"[^}]*why"
                              (graded->Gradescope (car (class-report-graded r))))))

(test-case "another run keeps them, and adds the rows of new answers"
  (define entries (read-table-text (typed "2.5" "good")))
  (define again (entered-points->CSV (report) entries))
  (check-equal? again (typed "2.5" "good"))
  (define more
    (report-of w (list ann) (list "ann@uni.edu" "Ann" '(answer 2) '(text "because"))
               '("d" "Dan" (answer 2) (text "new"))))
  (check-regexp-match #rx"\"2.5\",\"good\"\r\n\"d\",\"Dan\",\"why\",\"new\",\"3\",\"\",\"\"\r\n"
                      (entered-points->CSV more entries)))

(test-case "points of what is not handed in any more stay in the table, and are told"
  (define r (report-of w '() '("c" "Cem" (answer 2) (unanswered))))
  (define table (typed "2.5" "good"))
  (check-equal? (class-report-remarks (merged table r))
                '("points, line 2: ann@uni.edu is no submission"))
  (check-regexp-match #rx"\"ann@uni.edu\",\"\",\"why\",\"because\",\"\",\"2.5\",\"good\""
                      (entered-points->CSV r (read-table-text table))))

(define (row . cells) (string-append "submission,exercise,points\n" (string-join cells ",") "\n"))

(test-case "a judged answer can be marked, too; whoever it is may be named as the list does"
  (check-equal? (points-in (merged (row "=b" "two" "0.5"))) '(1 1/2 1))
  (check-equal? (points-in (merged (row "ANN@uni.edu" "two" "0"))) '(0 0 1)))

(test-case "nobody, no exercise, and answers that changed are told"
  (define (told text [r (report)]) (class-report-remarks (merged text r)))
  (check-equal? (told (row "zed" "two" "1")) '("points, line 2: zed is no submission"))
  (check-equal? (told (row "c" "tow" "1")) '("points, line 2: tow is no exercise"))
  (check-equal? (told (row "zed" "tow" "")) '())
  (check-equal? (told (typed "1" "") (report "something else"))
                (list (string-append "points, line 2: the answer of Ann, of \"A\" to why is "
                                     "another than when the points were entered")))
  (check-regexp-match #rx"\"because\",\"3\",\"1\""
                      (entered-points->CSV (report "something else")
                                           (read-table-text (typed "1" "")))))

(test-case "two who write the same table differently"
  (check-equal? (points-in (merged "Exercise;Submission;Points;x\nwhy;=b;3;\n")) '(1 3 1)))

(test-case "of two submissions of one participant each keeps its own row"
  (define r (report-of w (list ann) (list "one" "ann@uni.edu" '(answer 3) '(text "old"))
                       (list "ann@uni.edu" "Ann" '(answer 3) '(text "new"))))
  (check-equal? (points-in (merged (row "ann@uni.edu" "why" "1\none,why,2") r)) '(2 1))
  (check-equal? (points-in (merged (row "Ann@uni.edu" "why" "3") r)) '(3 0)))

(says
 [(merged (row "c" "two" "1\nc,two,"))
  "check: another line is about the same answer\n  file: points.csv\n  line: 3\n  given: c, two"]
 [(merged (row "c" "two" "1" "5"))
  (string-append "check: expected 3 fields, as in the first line; a field with a separator in it "
                 "stands in quotation marks\n  file: points.csv\n  line: 2\n  fields: 4")]
 [(merged (row "c" "two" "many"))
  "check: expected points, a number\n  file: points.csv\n  line: 2\n  given: many"]
 [(merged (row "c" "two" "\"1,000\""))
  (string-append "check: the comma may be that of a decimal or of thousands\n"
                 "  file: points.csv\n  line: 2\n  given: 1,000")]
 [(merged (row "c" "two" "-1"))
  "check: expected points, a number\n  file: points.csv\n  line: 2\n  given: -1"]
 [(merged (row "c" "two" "1.5"))
  "check: more points than the exercise has, 1\n  file: points.csv\n  line: 2\n  given: 1.5"]
 [(merged "submission,points\nc,1\n")
  "check: the file of points has no column exercise\n  file: points.csv\n"
  "  columns: submission, points"])
