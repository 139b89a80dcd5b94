#lang racket/base
;; The list of a class: a table as learning platforms export it, a row for each participant.
;;
;; It says by which e-mail, number or name a platform knows somebody, and perhaps when answers were
;; handed in.  A submission is its participant's if its file or folder is named after one of these,
;; or has the name in its line "Name:"; a platform's name counts before one that a student wrote.

(require racket/list
         racket/string
         "submission.rkt"
         (only-in "../../scale/data/CSV.rkt" read-text-table)
         (only-in "../worksheet/deadlines.rkt" text->seconds)
         "../../error/complain.rkt" "../../error/message-words.rkt")

(provide read-class-list (struct-out participant) participant-of participants-of
         participant-named
         identity-columns)

;; key       : the first of e-mail, number, user name and name, by which numbers are chosen
;; name      : for people
;; identity  : pairs of a column's name and the text there, those by which a platform knows them
;; known-as  : texts, normalized
;; handed-in : seconds since 1970, or #f; extension : days
(struct participant (key name identity known-as handed-in extension) #:transparent)

;; The columns, under the names that platforms give them, in lower case.
(define columns
  (hasheq 'e-mail '("email address" "e-mail address" "email" "e-mail" "mail")
          'number '("id number" "idnumber" "id" "sid" "student id" "student number")
          'user '("username" "user name" "login")
          'name '("full name" "name" "student")
          'first '("first name" "firstname" "given name")
          'last '("last name" "lastname" "surname" "family name")
          'platform '("identifier")
          'handed-in '("handed in" "last modified (submission)" "submission time")
          'extension '("extension")))

(define known-columns
  "\n  known are: Email address, ID number, Username, Full name, First name, Last name")

(define identities '(e-mail number user))

;; Somebody whom another program names
(define (participant-of e-mail name handed-in)
  (participant e-mail name '() (list (normalized e-mail)) handed-in 0))

(define (read-class-list who file)
  (define-values (names rows) (read-text-table who file))
  (define places (column-places names))
  (define (has? . sorts) (ormap (lambda (s) (hash-has-key? places s)) sorts))
  (unless (has? 'e-mail 'number 'user 'name 'last)
    (complain who "the list of the class has no column of ~a\n  file: ~a\n  columns: ~a~a"
              "e-mails, ID numbers or names" file (joined names) known-columns))
  (define all
    (for*/list ([row (in-list rows)]
                [p (in-value (row->participant who file names places row))]
                #:when p)
      p))
  (define twice (check-duplicates (map participant-key all)))
  (when twice
    (complain who "the list of the class has ~a twice\n  file: ~a" twice file))
  all)

;; -> hasheq, from the sorts of columns to their places
(define (column-places names)
  (for*/hasheq ([(sort known) (in-hash columns)]
                [known? (in-value (lambda (n) (member (string-downcase n) known)))]
                [place (in-value (index-where names known?))]
                #:when place)
    (values sort place)))

;; row : number of its line, fields -> participant, or #f of an empty row
(define (row->participant who file names places row)
  (define (field sort)
    (define place (hash-ref places sort #f))
    (and place (nonempty (string-trim (list-ref (cdr row) place)))))
  (define full
    (or (field 'name)
        (nonempty (string-join (filter values (list (field 'first) (field 'last)))))))
  (define keys (filter values (append (map field identities) (list full))))
  ;; Moodle writes a dash where nothing was handed in.
  (define (time text)
    (and text (not (equal? text "-"))
         (or (text->seconds text)
             (complain-of-field who file row "a time, as in 2026-11-20 18:00," text))))
  (define (days text)
    (define n (string->number (or text "0")))
    (if (and n (real? n)) n (complain-of-field who file row "a number of days" text)))
  (and (pair? keys)
       (participant (car keys) (or full (car keys))
                    (for/list ([s (in-list identities)] #:when (hash-has-key? places s))
                      (cons (list-ref names (hash-ref places s)) (or (field s) "")))
                    (map normalized (append keys (platform-numbers (field 'platform))
                                            (mail-names (field 'e-mail))))
                    (time (field 'handed-in)) (days (field 'extension)))))

(define (complain-of-field who file row expected given)
  (complain who "the list of the class should have ~a there\n  file: ~a\n  line: ~a\n  given: ~a"
            expected file (car row) given))

(define (nonempty text) (and (not (string=? text "")) text))

;; "Participant 1234", as Moodle's folders have it -> ("1234")
(define (platform-numbers text) (if text (regexp-match* #px"\\d+" text) '()))
;; ann@uni.edu -> ("ann")
(define (mail-names text) (if text (list (car (string-split text "@" #:trim? #f))) '()))

(define (normalized text)
  (string-foldcase (string-normalize-nfc (string-normalize-spaces text))))

;; The columns by which a platform can know who a row is for.
(define (identity-columns class)
  (if (null? class) '() (map car (participant-identity (car class)))))

;; ---------------------------------------------------------------------------
;; Whose is a submission?

;; -> list: the participant, or none, or several where it cannot be told
(define (participants-of class s)
  (define claims (append (folder-names (submission-id s)) (list (submission-person s))))
  (or (for/or ([text (in-list claims)])
        (define found (known-as class (normalized text)))
        (and (pair? found) found))
      '()))

(define (participant-named class text)
  (define found (known-as class (normalized text)))
  (and (pair? found) (null? (cdr found)) (car found)))

;; A key, which stands first, counts before all else.
(define (known-as class text)
  (define by-key (filter (lambda (p) (equal? text (car (participant-known-as p)))) class))
  (if (pair? by-key)
      by-key
      (filter (lambda (p) (member text (participant-known-as p))) class)))

;; Moodle's folders are called Ann Arbor_1234_assignsubmission_file_: the number counts before the
;; name, which two may have.
(define (folder-names id)
  (define m (regexp-match #px"^(.*)_(\\d+)_assignsubmission_" id))
  (if m (list (caddr m) (cadr m)) (list id)))
