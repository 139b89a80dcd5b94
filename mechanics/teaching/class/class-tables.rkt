#lang racket/base
;; The report on a class for other programs: as a table for spreadsheets, as JSON, and as the
;; results.json of Gradescope.

(require json
         (only-in racket/list append-map)
         (only-in racket/string string-append* string-join)
         "grade.rkt" "submission.rkt"
         "../../error/message-words.rkt"
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt")

(provide class->csv class->json graded->Gradescope class->text)

;; ---------------------------------------------------------------------------
;; CSV

;; A cell that begins like a formula would be a formula in a spreadsheet: it gets an apostrophe
;; before it, which marks text there.
(define (class->csv r)
  (define header
    (append '("submission" "name")
            (append-map (lambda (e) (list (exercise-name e) (format "~a points" (exercise-name e))))
                        (exercises-of (class-report-worksheet r)))
            '("points" "left to you" "problem")))
  (string-append* (for/list ([cells (in-list (cons header (map csv-row (class-report-graded r))))])
                    (string-append (string-join (map csv-cell cells) ",") "\r\n"))))

(define (csv-row g)
  (define s (graded-submission g))
  (append
   (list (submission-id s) (submission-person s))
   (append-map (lambda (j) (list (judged-status j) (points-cell (judged-points j))))
               (graded-answers g))
   (list (points-cell (graded-points g)) (graded-open g) (or (graded-problem g) ""))))

(define (points-cell n) (if n (number->text n) ""))

(define (csv-cell x)
  (define plain (regexp-replace* #px"[[:cntrl:]]+" (format "~a" x) " "))
  (define safe (if (regexp-match? #px"^\\s*[=+@\\-|%]" plain) (string-append "'" plain) plain))
  (string-append "\"" (regexp-replace* #rx"\"" safe "\"\"") "\""))

;; ---------------------------------------------------------------------------
;; JSON

(define (class->json r)
  (define w (class-report-worksheet r))
  (jsexpr->string
   (hasheq 'worksheet (worksheet-title w)
           'points (exact->inexact (total-points (exercises-of w)))
           'warning (or (class-report-warning r) (json-null))
           'submissions (map graded->jsexpr (class-report-graded r)))))

(define (graded->jsexpr g)
  (define s (graded-submission g))
  (hasheq 'submission (submission-id s)
          'name (submission-person s)
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

;; The file that Gradescope reads for a submission.  An answer that is left to a person has no
;; status there, which would be passed or failed.
(define (graded->Gradescope g)
  (jsexpr->string
   (hasheq 'score (exact->inexact (graded-points g))
           'output (string-join (graded-remarks g) "\n")
           'visibility "visible"
           'tests (map Gradescope-test (graded-answers g)))))

(define (Gradescope-test j)
  (define points (judged-points j))
  (define test
    (hasheq 'name (symbol->string (judged-name j))
            'score (exact->inexact (or points 0))
            'max_score (exact->inexact (exercise-points (judged-exercise j)))
            'output (judgment->text j)))
  (if points
      (hash-set test 'status (if (eq? (judged-status j) 'right) "passed" "failed"))
      test))

;; ---------------------------------------------------------------------------
;; Text

(define (class->text r)
  (define possible (number->text (total-points (exercises-of (class-report-worksheet r)))))
  (define lines
    (for/list ([g (in-list (class-report-graded r))])
      (format "~a  ~a of ~a~a~a" (submission-person (graded-submission g))
              (number->text (graded-points g)) possible
              (if (= 0 (graded-open g)) "" (format ", ~a left to you" (graded-open g)))
              (if (graded-problem g) (string-append ": " (first-line (graded-problem g))) ""))))
  (define warning (class-report-warning r))
  (string-join (if warning (list* warning "" lines) lines) "\n" #:after-last "\n"))
