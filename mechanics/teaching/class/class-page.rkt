#lang racket/base
;; The report on a class as a page of HTML: a table, common mistakes with their number, and each
;; submission with its answers typeset.
;;
;; A student's words are text on the page and nothing else, for the page is built as XML.

(require racket/file
         racket/list
         racket/runtime-path
         "grade.rkt" "submission.rkt"
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt"
         "../worksheet/written-answer.rkt"
         "../../algebra/notation/formula.rkt"
         "../../algebra/expression/write.rkt"
         "../../show/document/page-value.rkt" "../../show/document/web-page.rkt"
         "../../error/message-words.rkt"
         "../../generic/value-tree.rkt"
         "../../verdict/verdict.rkt")

(provide class->page)

(define-runtime-path style-sheet "class-page.css")

(define (class->page r)
  (define w (class-report-worksheet r))
  (define all (class-report-graded r))
  (page (worksheet-title w)
        (append (warning-part (class-report-warning r))
                (list (summary w all) (overview w all))
                (remarks-part (class-report-remarks r))
                (what-went-wrong w all)
                (append* (for/list ([g (in-list all)] [i (in-naturals 1)]) (section w g i))))
        #:style (file->string style-sheet)))

(define (warning-part text)
  (if text `((p ([class "warning"] [role "alert"]) ,(visible text))) '()))

(define (remarks-part remarks)
  (if (null? remarks)
      '()
      `((h2 "For you alone")
        (ul ,@(for/list ([text (in-list remarks)]) `(li ,(visible text)))))))

(define (summary w all)
  (define points (map graded-points all))
  (define open (apply + (map graded-open all)))
  `(p ,(visible (format "~a. On average ~a of ~a.~a"
                        (counted (length all) "submission")
                        (number->text (/ (apply + points) (max 1 (length all))))
                        (counted-points (total-points (exercises-of w)))
                        (if (= open 0) "" (format " Left to you: ~a." (counted open "answer")))))))

;; ---------------------------------------------------------------------------
;; The table

(define (overview w all)
  `(div ([class "table"])
        (table ([class "overview"])
               (thead (tr (th "Name")
                          ,@(for/list ([e (in-list (exercises-of w))])
                              `(th ,(visible (symbol->string (exercise-name e)))))
                          (th "Points")))
               (tbody ,@(for/list ([g (in-list all)] [i (in-naturals 1)]) (row g i))))))

(define (row g i)
  `(tr (td (a ([href ,(format "#s~a" i)]) ,(visible (graded-person g))))
       ,@(for/list ([j (in-list (graded-answers g))])
           (define status (judged-status j))
           `(td ([class ,(symbol->string status)] [title ,(status->words status)])
                ,(visible (cell-text status (judged-points j)))))
       (td ([class "total"]) ,(visible (number->text (graded-points g))))))

(define (cell-text status points)
  (case status
    [(undecided) "?"]
    [(kept) "to read"]
    [(unanswered) "–"]
    [(failed) "error"]
    [(marked) (format "✎ ~a" (number->text points))]
    [else (format "~a ~a" (case status [(right) "✓"] [(partly) "±"] [else "✗"])
                  (number->text points))]))

;; ---------------------------------------------------------------------------
;; Common mistakes

(define (times n) (if (= n 1) "once" (format "~a times" n)))

(define (what-went-wrong w all)
  (define wrong (filter wanting? (append-map graded-answers all)))
  (define rows
    (for*/list ([e (in-list (exercises-of w))]
                [name (in-value (exercise-name e))]
                [same (in-value (filter (lambda (j) (eq? name (judged-name j))) wrong))]
                [group (in-list (sort (group-by values (map mistake same)) > #:key length))])
      `(tr (td ,(visible (symbol->string name)))
           (td ,(visible (car group)))
           (td ,(visible (times (length group)))))))
  (if (null? rows)
      '()
      `((h2 "What went wrong") (div ([class "table"]) (table (tbody ,@rows))))))

(define (mistake j)
  (define words (judgment-words (judged-judgment j)))
  (if (pair? words) (car words) "it fails in another way"))

;; ---------------------------------------------------------------------------
;; A submission

(define (section w g i)
  (define id (submission-id (graded-submission g)))
  `((h2 ([id ,(format "s~a" i)]) ,(visible (graded-person g))
        ,@(if (equal? (graded-person g) id)
              '()
              `((span ([class "label"]) ,(visible (format " (~a)" id)))))
        ,(visible (format ": ~a of ~a" (number->text (graded-points g))
                          (counted-points (total-points (exercises-of w))))))
    ,@(if (graded-problem g)
          `((pre ([class "failure"]) ,(visible (graded-problem g))))
          '())
    ,@(for/list ([n (in-list (graded-notes g))]) `(p ([class "note"]) ,(visible n)))
    ,@(for/list ([j (in-list (graded-answers g))]
                 #:unless (equal? '(failed) (judged-answer j)))
        (answer-section j))))

(define (answer-section j)
  (define status (judged-status j))
  `(div ([class ,(format "judged ~a" status)])
        (p (span ([class "status"])
                 ,(visible (format "~a: ~a~a" (judged-name j) (status->words status)
                                   (points->text j)))))
        ,@(answer->xexprs (judged-answer j))
        ,@(answer->xexprs (reading-of (judged-exercise j) (judged-answer j)))
        ,@(for/list ([text (in-list (judgment-words (judged-judgment j)))])
            `(p ([class "said"]) ,(visible text)))
        ,@(evidence (judgment-verdict (judged-judgment j)))))

;; A proof without assumptions needs no more words.
(define (evidence v)
  (if (and v (not (and (proved? v) (null? (verdict-assumptions v)))))
      `((details (summary "verdict") ,@(tree->xexprs (value->tree v #t))))
      '()))

(define most-characters 1500)

(define (text->xexpr text) `(pre ([class "text"]) ,(visible text)))

;; The answer as it was written, not simplified.
(define (answer->xexprs d)
  (case (car d)
    [(answer)
     (define text (datum->text (cadr d)))
     (if (> (string-length text) most-characters)
         (list (text->xexpr (string-append (substring text 0 most-characters) " ...")))
         (with-handlers ([exn:fail? (lambda (e) (list (text->xexpr text)))])
           (tree->xexprs (plain-datum->tree (cadr d)))))]
    [(text) `((blockquote ,(visible (cadr d))))]
    [else '()]))
