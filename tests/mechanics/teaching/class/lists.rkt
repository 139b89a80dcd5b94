#lang racket/base
;; The list of a class: platforms' columns, whose a submission is, and what is said of lists that
;; cannot be read.

(require mechanics/teaching/class/class-list
         mechanics/teaching/class/submission
         racket/string
         "../../support/checks.rkt" "../../support/folder.rkt" "../../support/messages.rkt")

(define (read-lines . lines)
  (with-folder (folder)
    (define file (build-path folder "list.csv"))
    (call-with-output-file file (lambda (out) (write-string (string-join lines "\n") out)))
    (parameterize ([current-directory folder]) (read-class-list 'check "list.csv"))))

(define (handed-in id [person id]) (submission id person "" #f #f #f))
(define (names class s) (map participant-name (participants-of class s)))

;; ---------------------------------------------------------------------------

(define Moodle
  (read-lines "Identifier,Full name,ID number,Email address,Last modified (submission)"
              "Participant 501,\"Arbor, Ann\",1001,ann@uni.edu,\"Friday, 20 November 2026, 5:45 PM\""
              "Participant 502,Bob Bell,1002,bob@uni.edu,-"
              "Participant 503,Bob Bell,1003,Bell@uni.edu,"
              ",,,,"))

(test-case "a student of two names is found by either"
  (define cem (participant-of "Cem@uni.edu" "Cem Can" #f))
  (check-equal? (participant-key cem) "Cem@uni.edu")
  (check-equal? (names (list cem) (handed-in "cem@uni.edu")) '("Cem Can")))

(test-case "Moodle's columns: who it is, and when it was handed in"
  (check-equal? (map participant-key Moodle) '("ann@uni.edu" "bob@uni.edu" "Bell@uni.edu"))
  (check-equal? (identity-columns Moodle) '("Email address" "ID number"))
  (check-equal? (map (lambda (p) (and (participant-handed-in p) #t)) Moodle) '(#t #f #f)))

(test-case "Gradescope's, and those of a spreadsheet with semicolons"
  (define scope (read-lines "First Name,Last Name,SID,Email,Role" "Ann,Arbor,7,a@b.c,Student"))
  (check-equal? (map participant-name scope) '("Ann Arbor"))
  (check-equal? (identity-columns scope) '("Email" "SID"))
  (define sheet (read-lines "\uFEFFSurname;First name;Extension" "\"Ünal\";Çelik;2"))
  (check-equal? (map participant-key sheet) '("Çelik Ünal"))
  (check-equal? (map participant-extension sheet) '(2)))

(test-case "a submission is known by e-mail, number, name, or the platform's folder"
  (for ([(id name) (hash "ann@uni.edu" "Arbor, Ann" "ANN@uni.edu" "Arbor, Ann" "1002" "Bob Bell"
                         "ann" "Arbor, Ann" "arbor, ann" "Arbor, Ann"
                         "Arbor, Ann_501_assignsubmission_file_" "Arbor, Ann"
                         "Bob Bell_503_assignsubmission_file_answers" "Bob Bell")])
    (check-equal? (names Moodle (handed-in id)) (list name) id))
  (check-equal? (map participant-key
                     (participants-of Moodle (handed-in "Bob Bell_503_assignsubmission_file_")))
                '("Bell@uni.edu")))

(test-case "the name in the file counts where its own says nothing"
  (check-equal? (names Moodle (handed-in "pendulum" "Arbor,  Ann")) '("Arbor, Ann"))
  (check-equal? (names Moodle (handed-in "ann" "bob@uni.edu")) '("Arbor, Ann")))

(test-case "nobody, and one of two of the same name, are not guessed"
  (check-equal? (names Moodle (handed-in "eve")) '())
  (check-equal? (names Moodle (handed-in "Bob Bell")) '("Bob Bell" "Bob Bell")))

(test-case "accents may be composed or not"
  (define class (read-lines "Name,Email" "Çelik,c@d.e"))
  (check-equal? (names class (handed-in "C\u0327elik")) '("Çelik")))

;; ---------------------------------------------------------------------------

(says
 [(read-lines "Grade,Group" "1,2")
  "check: the list of the class has no column of e-mails, ID numbers or names\n  file: list.csv\n"
  "  columns: Grade, Group\n"
  "  known are: Email address, ID number, Username, Full name, First name, Last name"]
 [(read-lines "Email" "a@b.c" "d@e.f" "a@b.c")
  "check: the list of the class has a@b.c twice\n  file: list.csv"]
 [(read-lines "Email,Handed in" "a@b.c,yesterday")
  "check: the list of the class should have a time, as in 2026-11-20 18:00, there\n"
  "  file: list.csv\n  line: 2\n"
  "  given: yesterday"]
 [(read-lines "Email,Extension" "a@b.c,1" "b@b.c,one")
  "check: the list of the class should have a number of days there\n  file: list.csv\n  line: 3\n"
  "  given: one"]
 [(read-lines "") "check: the file is empty\n  file: list.csv"])
