#lang racket/base
;; The report on a class for other programs: as a table for spreadsheets, as JSON, and as the
;; results.json of Gradescope.

(require json
         (only-in racket/list append-map)
         (only-in racket/string string-join)
         "CSV-text.rkt" "class-list.rkt" "grade.rkt" "submission.rkt"
         "../../error/message-words.rkt"
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt")

(provide class->csv class->Moodle class->json graded->Gradescope class->text)

;; ---------------------------------------------------------------------------
;; CSV

(define (class->csv r)
  (define header
    (append '("submission" "name")
            (append-map (lambda (e) (list (exercise-name e) (format "~a points" (exercise-name e))))
                        (exercises-of (class-report-worksheet r)))
            '("points" "left to you" "problem" "notes")))
  (rows->CSV (cons header (map csv-row (class-report-graded r)))))

(define (csv-row g)
  (define s (graded-submission g))
  (append
   (list (submission-id s) (graded-person g))
   (append-map (lambda (j) (list (judged-status j) (points-cell (judged-points j))))
               (graded-answers g))
   (list (points-cell (graded-points g)) (graded-open g) (or (graded-problem g) "")
         (string-join (graded-notes g) "; "))))

(define (points-cell n) (if n (number->text n) ""))

;; ---------------------------------------------------------------------------
;; Moodle

;; For Moodle's import of grades: who it is, as the list of the class says, points and feedback,
;; which Moodle wants together.  Only participants are in it.
(define (class->Moodle r)
  (define title (worksheet-title (class-report-worksheet r)))
  (define columns (identity-columns (class-report-class r)))
  (rows->CSV
   (cons (append columns (list title (format "~a (feedback)" title)))
         (for*/list ([p (in-list (class-report-class r))]
                     [g (in-value (graded-of p r))]
                     #:when g)
           (append (map cdr (participant-identity p))
                   (list (number->text (graded-points g)) (feedback g)))))))

;; The first of somebody's submissions
(define (graded-of p r)
  (findf (lambda (g) (eq? p (graded-participant g))) (class-report-graded r)))

(define (feedback g)
  (string-join (append (graded-remarks g)
                       (for/list ([j (in-list (graded-answers g))])
                         (string-join (cons (format "~a: ~a~a" (judged-name j)
                                                    (status->words (judged-status j))
                                                    (points->text j))
                                            (judgment-words (judged-judgment j)))
                                      "; ")))
               ". "))

;; ---------------------------------------------------------------------------
;; JSON

(define (class->json r)
  (define w (class-report-worksheet r))
  (jsexpr->string
   (hasheq 'worksheet (worksheet-title w)
           'points (exact->inexact (total-points (exercises-of w)))
           'warning (or (class-report-warning r) (json-null))
           'remarks (class-report-remarks r)
           'submissions (map graded->jsexpr (class-report-graded r)))))

(define (graded->jsexpr g)
  (define s (graded-submission g))
  (hasheq 'submission (submission-id s)
          'name (graded-person g)
          'points (exact->inexact (graded-points g))
          'open (graded-open g)
          'problem (or (graded-problem g) (json-null))
          'notes (graded-notes g)
          'answers (map answer->jsexpr (graded-answers g))))

(define (answer->jsexpr j)
  (define-values (points d) (values (judged-points j) (judged-answer j)))
  (hasheq 'exercise (symbol->string (judged-name j))
          'status (symbol->string (judged-status j))
          'points (if points (exact->inexact points) (json-null))
          'of (exact->inexact (exercise-points (judged-exercise j)))
          'words (judgment-words (judged-judgment j))
          'verdict (evidence-lines j #t)
          'answer (if (pair? (cdr d)) (format "~a" (cadr d)) (json-null))))

;; The file that Gradescope reads for a submission.  An answer that is a person's affair has no
;; status there, which would be passed or failed.
(define (graded->Gradescope g)
  (jsexpr->string
   (hasheq 'score (exact->inexact (graded-points g))
           'output (string-join (graded-remarks g) "\n")
           'visibility "visible"
           'tests (map Gradescope-test (graded-answers g)))))

(define (Gradescope-test j)
  (define points (judged-points j))
  (define status (judged-status j))
  (define test
    (hasheq 'name (symbol->string (judged-name j))
            'score (exact->inexact (or points 0))
            'max_score (exact->inexact (exercise-points (judged-exercise j)))
            'output (judgment->text j)))
  (if (and points (not (eq? status 'marked)))
      (hash-set test 'status (if (eq? status 'right) "passed" "failed"))
      test))

;; ---------------------------------------------------------------------------
;; Text

(define (class->text r)
  (define possible (number->text (total-points (exercises-of (class-report-worksheet r)))))
  (define lines
    (for/list ([g (in-list (class-report-graded r))])
      (format "~a  ~a of ~a~a~a" (graded-person g)
              (number->text (graded-points g)) possible
              (if (= 0 (graded-open g)) "" (format ", ~a left to you" (graded-open g)))
              (if (graded-problem g) (string-append ": " (first-line (graded-problem g))) ""))))
  (define warning (class-report-warning r))
  (define remarks (class-report-remarks r))
  (string-join (append (if warning (list warning "") '())
                       lines
                       (if (pair? remarks) (cons "" remarks) '()))
               "\n" #:after-last "\n"))
