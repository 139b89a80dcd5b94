#lang racket/base
;; Points that the teacher enters by hand, in a table: a row for each answer that is left to a
;; person.
;;
;; The table is written with the answers in it, and the points empty.  Points entered in it are kept
;; when the class is judged again, whatever the judgments are then; rows can be added for other
;; answers.  Rows stand by exercise, since one marks the same question of all.

(require racket/list
         racket/string
         "CSV-text.rkt" "class-list.rkt" "grade.rkt" "submission.rkt"
         (only-in "../../scale/data/CSV.rkt" read-text-table)
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt"
         "../../error/complain.rkt" "../../error/message-words.rkt")

(provide read-entered-points with-entered-points entered-points->CSV)

;; A row.  submission, exercise, answer, comment : texts; points : number, or #f
(struct entry (line submission exercise answer points comment) #:transparent)

(define columns '("submission" "name" "exercise" "answer" "of" "points" "comment"))
(define-values (submission-at exercise-at answer-at points-at comment-at) (values 0 2 3 5 6))

(define (read-entered-points who file)
  (define-values (names rows) (read-text-table who file))
  (define places (for/list ([c (in-list columns)]) (index-of (map string-downcase names) c)))
  (define missing
    (for/list ([c (in-list columns)] [p (in-list places)]
               #:when (and (not p) (member c '("submission" "exercise" "points"))))
      c))
  (when (pair? missing)
    (complain who "the file of points has no column ~a\n  file: ~a\n  columns: ~a"
              (joined missing " and no column ") file (joined names)))
  (for/list ([row (in-list rows)])
    (define (field k)
      (define place (list-ref places k))
      (if place (string-trim (CSV-cell-text (list-ref (cdr row) place))) ""))
    (entry (car row) (field submission-at) (field exercise-at) (field answer-at)
           (text->points who file (car row) (field points-at))
           (field comment-at))))

;; A comma is a decimal point, too; but in "1,000" it may be none.
(define (text->points who file line text)
  (when (regexp-match? #px"^[1-9]\\d*,\\d{3}$" text)
    (complain who
              (string-append "the comma may be that of a decimal or of thousands"
                             "\n  file: ~a\n  line: ~a\n  given: ~a")
              file line text))
  (define n (string->number (string-replace text "," ".") 10 'number-or-false 'decimal-as-exact))
  (cond [(string=? text "") #f]
        [(and n (real? n) (>= n 0)) n]
        [else (complain who "expected points, a number\n  file: ~a\n  line: ~a\n  given: ~a"
                        file line text)]))

;; ---------------------------------------------------------------------------
;; Merging

;; -> the report with the points, and remarks on rows that are of nobody or out of date
(define (with-entered-points who file r entries)
  (define all (class-report-graded r))
  (for ([e (in-list entries)]) (check-most who file e (class-report-worksheet r)))
  (check-once who file all entries)
  (define remarks (append-map (lambda (e) (remarks-on e r)) entries))
  (define found (entries-by-place all entries))
  (struct-copy class-report r
               [graded (for/list ([g (in-list all)]) (with-points g found))]
               [remarks (append (class-report-remarks r) remarks)]))

(define (check-most who file e w)
  (define x (exercise-of e w))
  (when (and x (entry-points e) (> (entry-points e) (exercise-points x)))
    (complain who "more points than the exercise has, ~a\n  file: ~a\n  line: ~a\n  given: ~a"
              (number->text (exercise-points x)) file (entry-line e)
              (number->text (entry-points e)))))

(define (check-once who file all entries)
  (define (place-of e)
    (define g (graded-of e all))
    (if g (place g (entry-exercise e)) e))
  (define twice (check-duplicates entries #:key place-of))
  (when twice
    (complain who "another line is about the same answer\n  file: ~a\n  line: ~a\n  given: ~a, ~a"
              file (entry-line twice) (entry-submission twice) (entry-exercise twice))))

(define (exercise-of e w)
  (findf (lambda (x) (equal? (entry-exercise e) (symbol->string (exercise-name x))))
         (exercises-of w)))

(define (remarks-on e r)
  (define (told text . parts)
    (list (format "points, line ~a: ~a" (entry-line e) (apply format text parts))))
  (define g (graded-of e (class-report-graded r)))
  (define j (and g (findf (lambda (j) (about? e j)) (graded-answers g))))
  (cond [(not (or (entry-points e) (nonempty? (entry-comment e)))) '()]
        [(not g) (told "~a is no submission" (entry-submission e))]
        [(not j) (told "~a is no exercise" (entry-exercise e))]
        [(and (nonempty? (entry-answer e)) (not (same-answer? (entry-answer e) j)))
         (told "the answer of ~a to ~a is another than when the points were entered"
               (graded-person g) (entry-exercise e))]
        [else '()]))

(define (nonempty? text) (not (string=? text "")))

;; -> the graded submission that the row names by itself, else the first of the participant whom
;; it names, or #f
(define (graded-of e all)
  (define id (entry-submission e))
  (define (named? g) (equal? id (graded-id g)))
  (define (known? g)
    (define p (graded-participant g))
    (and p (participant-named (list p) id)))
  (or (findf named? all) (findf known? all)))

(define (graded-id g) (submission-id (graded-submission g)))

;; name : of an exercise
(define (place g name) (cons (graded-id g) (format "~a" name)))

;; -> place -> entry
(define (entries-by-place all entries)
  (for*/hash ([e (in-list entries)] [g (in-value (graded-of e all))] #:when g)
    (values (place g (entry-exercise e)) e)))

(define (about? e j) (equal? (entry-exercise e) (symbol->string (judged-name j))))
(define (same-answer? text j)
  (define (plain t) (string-normalize-spaces t))
  (equal? (plain text) (plain (CSV-cell-text (CSV-safe (answer-text j))))))

(define (with-points g found)
  (struct-copy graded g
               [answers (for/list ([j (in-list (graded-answers g))])
                          (define e (hash-ref found (place g (judged-name j)) #f))
                          (if e (marked j e) j))]))

(define (marked j e)
  (define old (judged-judgment j))
  (define most (exercise-points (judged-exercise j)))
  (define words
    (append (if (nonempty? (entry-comment e)) (list (entry-comment e)) '()) (judgment-words old)))
  (struct-copy judged j
               [judgment (cond [(not (entry-points e)) (struct-copy judgment old [words words])]
                               [else (judgment 'marked
                                               (if (zero? most) 0 (/ (entry-points e) most))
                                               (judgment-verdict old) words)])]))

;; ---------------------------------------------------------------------------
;; Writing

;; r : report without the points; entries : kept, whether something was entered in them or not
(define (entered-points->CSV r entries)
  (define all (class-report-graded r))
  (define found (entries-by-place all entries))
  (define rows
    (for*/list ([x (in-list (exercises-of (class-report-worksheet r)))]
                [g (in-list all)]
                [j (in-list (graded-answers g))]
                #:when (eq? (judged-name j) (exercise-name x))
                [e (in-value (hash-ref found (place g (judged-name j)) #f))]
                #:when (or e (not (judged-points j))))
      (row g j e)))
  (define lost
    (for/list ([e (in-list entries)] #:unless (belongs? e all))
      (list (entry-submission e) "" (entry-exercise e) (entry-answer e) ""
            (points-text e) (entry-comment e))))
  (string-append "\uFEFF" (rows->CSV (cons columns (append rows lost)))))

(define (belongs? e all)
  (define g (graded-of e all))
  (and g (ormap (lambda (j) (about? e j)) (graded-answers g))))

;; The answer for which points were entered stays.
(define (row g j e)
  (define entered? (and e (entry-points e) (nonempty? (entry-answer e))))
  (list (graded-id g) (graded-person g) (judged-name j)
        (if entered? (entry-answer e) (answer-text j))
        (number->text (exercise-points (judged-exercise j)))
        (if e (points-text e) "")
        (if e (entry-comment e) "")))

(define (points-text e) (if (entry-points e) (number->text (entry-points e)) ""))

(define (answer-text j)
  (define d (judged-answer j))
  (if (pair? (cdr d)) (format "~a" (cadr d)) ""))
