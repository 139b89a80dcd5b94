#lang racket/base
;; The report on a class as a page of HTML: a table, what went wrong how often, and each
;; submission with its answers typeset.
;;
;; Whatever a student wrote is text on the page and nothing else, for the page is built as XML.

(require racket/file
         racket/list
         racket/runtime-path
         "grade.rkt" "submission.rkt"
         "../worksheet/exercise.rkt" "../worksheet/judgment-words.rkt" "../worksheet/judgment.rkt"
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
                (what-went-wrong w all)
                (append* (for/list ([g (in-list all)] [i (in-naturals 1)]) (section w g i))))
        #:style (file->string style-sheet)))

(define (warning-part text)
  (if text `((p ([class "warning"] [role "alert"]) ,(visible text))) '()))

(define (summary w all)
  (define points (for/list ([g (in-list all)]) (graded-points g w)))
  (define open (for/sum ([g (in-list all)]) (graded-open g)))
  `(p ,(visible (format "~a. On average ~a of ~a.~a"
                        (counted (length all) "submission")
                        (number->text (/ (apply + points) (max 1 (length all))))
                        (counted-points (total-points w))
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
               (tbody ,@(for/list ([g (in-list all)] [i (in-naturals 1)]) (row w g i))))))

(define (row w g i)
  `(tr (td (a ([href ,(format "#s~a" i)]) ,(visible (person g))))
       ,@(for/list ([j (in-list (graded-judgments g))] [e (in-list (exercises-of w))])
           `(td ([class ,(symbol->string (judgment-status j))]
                 [title ,(status->words (judgment-status j))])
                ,(visible (cell-text e j))))
       (td ([class "total"]) ,(visible (number->text (graded-points g w))))))

(define (cell-text e j)
  (define points (judgment-points j (exercise-points e)))
  (case (judgment-status j)
    [(undecided) "?"]
    [(kept) "to read"]
    [(unanswered) "–"]
    [(failed) "error"]
    [else (format "~a ~a" (mark j) (number->text points))]))

(define (mark j) (case (judgment-status j) [(right) "✓"] [(partly) "±"] [else "✗"]))

(define (person g) (submission-person (graded-submission g)))

;; ---------------------------------------------------------------------------
;; What went wrong

(define (times n) (if (= n 1) "once" (format "~a times" n)))

(define (what-went-wrong w all)
  (define rows
    (append*
     (for/list ([e (in-list (exercises-of w))] [k (in-naturals)])
       (define said
         (for*/list ([g (in-list all)]
                     [j (in-value (list-ref (graded-judgments g) k))]
                     #:when (memq (judgment-status j) '(wrong partly trivial)))
           (if (pair? (judgment-words j)) (car (judgment-words j)) "it fails in another way")))
       (for/list ([group (in-list (sort (group-by values said) > #:key length))])
         (list (exercise-name e) (car group) (length group))))))
  (if (null? rows)
      '()
      `((h2 "What went wrong")
        (div ([class "table"])
             (table (tbody ,@(for/list ([r (in-list rows)])
                               `(tr (td ,(visible (symbol->string (first r))))
                                    (td ,(visible (second r)))
                                    (td ,(visible (times (third r))))))))))))

;; ---------------------------------------------------------------------------
;; A submission

(define (section w g i)
  (define s (graded-submission g))
  `((h2 ([id ,(format "s~a" i)]) ,(visible (person g))
        ,@(if (equal? (person g) (submission-id s))
              '()
              `((span ([class "label"]) ,(visible (format " (~a)" (submission-id s))))))
        ,(visible (format ": ~a of ~a" (number->text (graded-points g w))
                          (counted-points (total-points w)))))
    ,@(if (graded-problem g)
          `((pre ([class "failure"]) ,(visible (graded-problem g))))
          '())
    ,@(for/list ([n (in-list (graded-notes g))]) `(p ([class "note"]) ,(visible n)))
    ,@(for/list ([e (in-list (exercises-of w))] [j (in-list (graded-judgments g))]
                 #:unless (and (eq? 'failed (judgment-status j)) (null? (judgment-words j))))
        (judged-answer e j (hash-ref (graded-answers g) (exercise-name e) '(unanswered))))))

(define (judged-answer e j d)
  `(div ([class ,(format "judged ~a" (judgment-status j))])
        (p (span ([class "status"])
                 ,(visible (format "~a: ~a~a" (exercise-name e) (status->words (judgment-status j))
                                   (points->text e j)))))
        ,@(answer->xexprs d)
        ,@(for/list ([text (in-list (judgment-words j))])
            `(p ([class "said"]) ,(visible text)))
        ,@(evidence (judgment-verdict j) j)))

;; A proof needs no more words.
(define (evidence v j)
  (if (and v (not (and (proved? v) (null? (verdict-assumptions v)))))
      `((details (summary "verdict") ,@(tree->xexprs (value->tree v #t))))
      '()))

(define most-characters 1500)

(define (text->xexpr text) `(pre ([class "text"]) ,(visible text)))

;; As it was written, not simplified.
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
