#lang racket/base
;; A class from its list to its grades: worksheets with each student's numbers, the list and the
;; points in `raco mechanics check`, and an archive in place of a folder.

(require file/zip
         json
         (only-in mechanics/lang/command/written-files plain-file-name)
         racket/list
         racket/string
         "../../support/checks.rkt" "../../support/worksheet-folder.rkt")

(write-text "w.rkt" "#lang mechanics/worksheet" "(title \"Numbers\")"
            "(deadline \"2026-11-20 12:00 Z\" #:per-day 1/4)" "(credit #:sign 1/2)"
            "(parameters #:seed 7 [l 1 3/2 2 5/2] [m #:from 0.1 #:to 0.5 #:step 0.1])"
            "(text \"A rod of \" l \" m.\")"
            "(exercise double number (format \"Twice ~a?\" l) (key (* 2 l)) (points 2))"
            "(exercise root expression \"?\" (key (sqrt (/ 'g l))) (points 2))"
            "(exercise why reason \"Why?\" (points 4))")
(write-text "list.csv" "Full name,Email address,Handed in,Extension"
            "\"Arbor, Ann\",ann@uni.edu,2026-11-20 11:59 Z,"
            "Bob Bell,bob@uni.edu,2026-11-21 11:00 Z,"
            "Cem,cem@uni.edu,2026-11-22 11:00 Z,2" "Dan,dan@uni.edu,,")

(define (number-in name)
  (string->number (cadr (regexp-match #px"\\(define l ([\\d/]+)\\)" (text name)))))

;; ---------------------------------------------------------------------------

(test-case "each student of the list gets a program and a notebook, with numbers of their own"
  (check-equal? (command "worksheet" "w.rkt" "--class" "list.csv")
                '(0 "w-students: a program and a notebook for each of 4 students\n"))
  (check-equal? (length (directory-list (in-folder "w-students"))) 8)
  (define l (number-in "w-students/ann@uni.edu.rkt"))
  (check-regexp-match (string-append ";; The numbers of ann@uni.edu\n"
                                     (format "\\(define l ~a\\)\n\\(define m 0.[1-5]\\)" l))
                      (text "w-students/ann@uni.edu.rkt"))
  (check-true (string-contains? (text "w-students/ann@uni.edu.rkt") (format "A rod of ~a m." l)))
  (check-true (string-contains? (text "w-students/ann@uni.edu.rkt") (format "Twice ~a?" l)))
  (check-true (string-contains? (text "w-students/ann@uni.edu.ipynb") (format "(define l ~a)" l)))
  (check-true (> (length (remove-duplicates
                          (for/list ([s '("ann" "bob" "cem" "dan")])
                            (number-in (format "w-students/~a@uni.edu.rkt" s)))))
                 1)))

(test-case "names in any script are names of files"
  (check-equal? (map plain-file-name '("李雷" "Zoë Ünal" "a/b:c" ".."))
                '("李雷" "Zoë Ünal" "a_b_c" "_..")))

(test-case "one student's by name is the same as that of the list"
  (check-equal? (first (command "worksheet" "w.rkt" "--student" "ann@uni.edu" "-o" "one.rkt")) 0)
  (check-equal? (text "one.rkt") (text "w-students/ann@uni.edu.rkt"))
  (check-regexp-match #rx"A rod of" (text "one.html"))
  (check-equal? (first (command "worksheet" "w.rkt")) 0)
  (check-false (string-contains? (text "w-student.rkt") "The numbers of")))

;; ---------------------------------------------------------------------------

(define (answers-of student . answers)
  (answered (text (format "w-students/~a@uni.edu.rkt" student))
            (for/list ([a (in-list answers)] [name '("double" "root" "why")]) (list name a))))

(make-directory (in-folder "class"))
(write-text "class/ann@uni.edu.rkt"
            (answers-of "ann" "(* 2 l)" "(sqrt (/ 'g l))" "\"Since it must.\""))
(write-text "class/Bob Bell_12_assignsubmission_file_.rkt"
            (answers-of "ann" "(* 2 l)" "(- (sqrt (/ 'g l)))"))
(write-text "class/cem.rkt" (answers-of "cem" "(* 2 l)" "(- (sqrt (/ 'g l)))"))
(write-text "class/eve.rkt" (answers-of "dan" "(* 2 l)"))

(define (check-class class . more)
  (apply command "check" class "--worksheet" "w.rkt" "--class" "list.csv" "--seconds" "600" more))

(define listed
  (list "Arbor, Ann  4 of 8, 1 left to you" #rx"Bob Bell  [0-9.]+ of 8" "Cem  3 of 8"
        #rx"^eve  0 of 8: whose it is the list of the class does not tell, so its numbers are not"
        "" "of nobody on the list of the class: eve" "nothing was handed in by Dan"))

(define (check-lines said expected)
  (define lines (regexp-split #rx"\n" said))
  (for ([e (in-list expected)])
    (check-true (for/or ([l (in-list lines)]) (if (regexp? e) (regexp-match? e l) (equal? e l)))
                (format "~s in ~s" e lines))))

(test-case "a class is judged by its list: numbers, lateness, extensions, nobody's submissions"
  (define result (check-class "class" "--points" "points.csv" "--moodle" "m.csv" "--report" "r.json"
                              "--report" "r.html"))
  (check-equal? (first result) 0)
  (check-lines (second result) (cons "m.csv: 1 answer left to you, with no points in it yet"
                                     listed))
  (define all (hash-ref (string->jsexpr (text "r.json")) 'submissions))
  (define (notes k) (hash-ref (list-ref all k) 'notes))
  (define bob (index-where all (lambda (s) (equal? "Bob Bell" (hash-ref s 'name)))))
  (check-equal? (notes bob) '("handed in 23 hours after the deadline: 25 % taken off"
                              "the numbers in it are those of ann@uni.edu"))
  (check-true (regexp-match? #rx"For you alone.*of nobody on the list" (text "r.html")))
  (check-true (regexp-match? #rx"What went wrong.*root</td><td>the sign is" (text "r.html"))
              "of numbers of their own, too"))

(test-case "points that are entered count, and are kept; an archive is judged as its folder is"
  (define table (text "points.csv"))
  (check-regexp-match #rx"\"ann@uni.edu\",\"Arbor, Ann\",\"why\",\"Since it must.\",\"4\",\"\",\"\""
                      table)
  (write-text "points.csv" (string-replace table "\"4\",\"\",\"\"" "\"4\",\"3.5\",\"and why?\""))
  (parameterize ([current-directory folder]) (zip "class.zip" "class"))
  (check-lines (second (check-class "class.zip" "--points" "points.csv" "--moodle" "m.csv"))
               (cons "Arbor, Ann  7.5 of 8" (rest listed)))
  (check-regexp-match #rx"\"3.5\",\"and why[?]\"" (text "points.csv"))
  (check-regexp-match #rx"\"ann@uni.edu\",\"7.5\",\".*marked by the teacher \\(3.5 of 4 points\\); "
                      (text "m.csv"))
  (write-text "points.csv" (string-replace (text "points.csv") "\"3.5\"" "\"4.5\""))
  (check-regexp-match #rx"^check: more points than the exercise has, 4\n  file: points.csv\n"
                      (second (check-class "class" "--points" "points.csv"))))

(test-case "one file is judged with the numbers of its student"
  (define one (in-folder "class/cem.rkt"))
  (check-regexp-match #rx"\n1. double: right"
                      (second (command "check" (path->string one) "--worksheet" "w.rkt"
                                       "--student" "cem@uni.edu"))))

;; ---------------------------------------------------------------------------

(write-text "bad.zip" "no archive")
(write-text "twins.csv" "username\nann/a\nAnn_A\n")
(write-text "wide.csv" "")
(call-with-output-file (in-folder "wide.csv") #:exists 'truncate
  (lambda (out) (write-bytes #"\377\376e\0-\0m\0a\0i\0l\0\n\0" out)))
(test-case "what is missing or makes no sense is told"
  (check-refused #rx"^check: each student has numbers of their own: the list of the class is needed"
                 "check" "class" "--worksheet" "w.rkt")
  (check-refused #rx"^check: each student has numbers of their own: name the one whose file it is"
                 "check" "class/cem.rkt" "--worksheet" "w.rkt")
  (check-refused #rx"^check: Moodle knows people by e-mail or ID number: --moodle needs the list"
                 "check" "class" "--worksheet" "w.rkt" "--moodle" "m.csv")
  (check-refused #rx"^check: --student is for one file; a class has its list, as in --class"
                 "check" "class" "--worksheet" "w.rkt" "--student" "ann")
  (for ([option '("--class" "--points" "--moodle")])
    (check-refused #rx"^check: --class, --points and --moodle are for a class" "check"
                   "class/cem.rkt" "--worksheet" "w.rkt" option "list.csv"))
  (check-refused #rx"^check: there is no such file" "check" "class" "--worksheet" "w.rkt" "--class"
                 "none.csv")
  (check-refused #rx"^check: it writes a file that ends with .csv\n  given: p.xlsx" "check" "class"
                 "--worksheet" "w.rkt" "--points" "p.xlsx")
  (check-refused #rx"^worksheet: it is either for a --class or for a --student" "worksheet" "w.rkt"
                 "--class" "list.csv" "--student" "ann")
  (check-refused #rx"^worksheet: there is no such file" "worksheet" "w.rkt" "--class" "none.csv")
  (check-refused #rx"^worksheet: another student's files .* the same name\n  file: twins.csv\n"
                 "worksheet" "w.rkt" "--class" "twins.csv")
  (check-refused #rx"^worksheet: the file is no text in UTF-8; save it as CSV UTF-8"
                 "worksheet" "w.rkt" "--class" "wide.csv")
  (check-refused #rx"^check: it is no ZIP archive" "check" "bad.zip" "--worksheet" "w.rkt"
                 "--class" "list.csv"))

(define title "(title \"Bad\")")

(test-case "a worksheet's mistakes with deadlines, parameters and credit are told"
  (check-worksheet #rx"deadline: a deadline is a time, with what lateness costs perhaps" title
                   "(deadline \"2026-11-20 12:00\" #:per-hour 1)")
  (check-worksheet #rx"^deadline: expected a time, as in" title "(deadline \"Friday\")")
  (check-worksheet #rx"parameters: parameters are names with their values" title
                   "(parameters l 1 2)")
  (check-worksheet #rx"^parameters: l has no value" title "(parameters [l])")
  (check-worksheet #rx"credit: the clause `credit` takes shares of the points" title "(credit)")
  (check-worksheet #rx"credit: the clause `credit` takes no keyword #:signs" title
                   "(credit #:signs 1)")
  (check-worksheet #rx"^a: the credit of a slip is a share" title "(credit #:sign 2)"
                   "(exercise a number \"?\" (key 1))"))

(delete-folder)
