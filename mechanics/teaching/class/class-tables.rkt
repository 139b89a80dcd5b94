#lang racket/base
;; The report on a class for other programs: as a table for spreadsheets, as JSON, and as the
;; results.json of Gradescope.

(require json
         (only-in racket/string string-append* string-join)
         "grade.rkt" "submission.rkt"
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt")

(provide class->csv class->json graded->Gradescope class->text)

;; ---------------------------------------------------------------------------
;; CSV

;; A cell that begins like a formula would be one in a spreadsheet; it gets an apostrophe
;; before it, which spreadsheets take for the mark of a text.
(define (class->csv r)
  (define w (class-report-worksheet r))
  (define names (for/list ([e (in-list (exercises-of w))]) (symbol->string (exercise-name e))))
  (define header
    (append '("submission" "name")
            (apply append (for/list ([n (in-list names)]) (list n (string-append n " points"))))
            '("points" "left to you" "problem")))
  (string-append* (for/list ([cells (in-list (cons header (map (lambda (g) (csv-row w g))
                                                               (class-report-graded r))))])
                    (string-append (string-join (map csv-cell cells) ",") "\r\n"))))

(define (csv-row w g)
  (define s (graded-submission g))
  (append
   (list (submission-id s) (submission-person s))
   (apply append
          (for/list ([j (in-list (graded-judgments g))] [e (in-list (exercises-of w))])
            (define points (judgment-points j (exercise-points e)))
            (list (symbol->string (judgment-status j)) (if points (number->text points) ""))))
   (list (number->text (graded-points g w)) (number->string (graded-open g))
         (or (graded-problem g) ""))))

(define (csv-cell text)
  (define plain (regexp-replace* #px"[[:cntrl:]]+" text " "))
  (define safe (if (regexp-match? #px"^\\s*[=+@\\-|%]" plain) (string-append "'" plain) plain))
  (string-append "\"" (regexp-replace* #rx"\"" safe "\"\"") "\""))

;; ---------------------------------------------------------------------------
;; JSON

(define (class->json r)
  (define w (class-report-worksheet r))
  (jsexpr->string
   (hasheq 'worksheet (worksheet-title w)
           'points (decimal (total-points w))
           'warning (or (class-report-warning r) (json-null))
           'submissions (for/list ([g (in-list (class-report-graded r))]) (graded->jsexpr w g)))))

(define (graded->jsexpr w g)
  (define s (graded-submission g))
  (hasheq 'submission (submission-id s)
          'name (submission-person s)
          'points (decimal (graded-points g w))
          'open (graded-open g)
          'problem (or (graded-problem g) (json-null))
          'notes (graded-notes g)
          'answers (for/list ([j (in-list (graded-judgments g))] [e (in-list (exercises-of w))])
                     (answer->jsexpr e j (hash-ref (graded-answers g) (exercise-name e) #f)))))

(define (answer->jsexpr e j d)
  (define points (judgment-points j (exercise-points e)))
  (hasheq 'exercise (symbol->string (exercise-name e))
          'status (symbol->string (judgment-status j))
          'points (if points (decimal points) (json-null))
          'of (decimal (exercise-points e))
          'words (judgment-words j)
          'verdict (evidence-lines e j #t)
          'answer (if (and d (pair? (cdr d))) (format "~a" (cadr d)) (json-null))))

(define (decimal x) (exact->inexact x))

;; What Gradescope reads for one submission; what is left to a person has no status, which
;; would be passed or failed.
(define (graded->Gradescope w g)
  (jsexpr->string
   (hasheq 'score (decimal (graded-points g w))
           'output (string-join (append (if (graded-problem g) (list (graded-problem g)) '())
                                        (graded-notes g))
                                "\n")
           'visibility "visible"
           'tests (for/list ([j (in-list (graded-judgments g))] [e (in-list (exercises-of w))])
                    (Gradescope-test e j)))))

(define (Gradescope-test e j)
  (define points (judgment-points j (exercise-points e)))
  (define test
    (hasheq 'name (symbol->string (exercise-name e))
            'score (decimal (or points 0))
            'max_score (decimal (exercise-points e))
            'output (judgment->text e j)))
  (if (judgment-share j)
      (hash-set test 'status (if (eq? (judgment-status j) 'right) "passed" "failed"))
      test))

;; ---------------------------------------------------------------------------
;; Text

(define (class->text r)
  (define w (class-report-worksheet r))
  (define lines
    (for/list ([g (in-list (class-report-graded r))])
      (format "~a  ~a of ~a~a~a" (submission-person (graded-submission g))
              (number->text (graded-points g w)) (number->text (total-points w))
              (if (= 0 (graded-open g)) "" (format ", ~a left to you" (graded-open g)))
              (if (graded-problem g) (string-append ": " (one-line (graded-problem g))) ""))))
  (string-join (append (if (class-report-warning r) (list (class-report-warning r) "") '()) lines)
               "\n" #:after-last "\n"))

(define (one-line text) (regexp-replace #rx"\n.*" text ""))
