#lang racket/base
;; The student's notebook: each question as text with formulas typeset, beneath it a cell with the
;; hole to fill and `(check name)`, which judges the answer in place.
;;
;; The first cell opens the envelope of the exercises; it is folded.

(require (only-in racket/list append-map)
         (only-in racket/string string-join)
         "exercise-kind.rkt" "exercise.rkt" "handout.rkt" "judgment-words.rkt" "student-file.rkt"
         "../../algebra/notation/tree.rkt"
         "../../show/notebook/notebook-file.rkt" "../../show/notebook/program-cells.rkt"
         "../../show/typesetting/TeX.rkt")

(provide worksheet->student-notebook)

;; run : cells -> outputs of each, or #f -> bytes
(define (worksheet->student-notebook w [run #f])
  (define opening (opening-cell (exercises-of w)))
  (define cells
    (append (list (text-cell (title-text w)) opening)
            (append-map (part->cells (numbered-exercises w)) (worksheet-parts w))
            (list (text-cell "### All answers")
                  (code-cell (check-call (map exercise-name (exercises-of w)))))))
  (notebook->bytes usual-header cells (if run (run cells) (map (lambda (_) '()) cells))
                   #:folded? (lambda (c) (eq? c opening))))

(define (text-cell text) (cell 'markdown text #f #f))
(define (code-cell text) (cell 'code text #f #f))

(define (title-text w)
  (string-join
   (list (string-append "# " (Markdown-escaped (worksheet-title w)))
         (if (worksheet-due w) (format "Due: ~a\n" (Markdown-escaped (worksheet-due w))) "")
         "Name: \n"
         instructions)
   "\n"))

(define instructions
  (string-append
   "Run all cells (menu *Run*). Then put your answers in place of `unanswered`, and run the cell: "
   "the answer is proved, refuted with a point where it fails, or left to your teacher. Symbols "
   "such as `'m` stand for any number; a formula may also be a text as on paper, such as "
   "`\"m x'' + k x = 0\"`. At the end save the notebook, and hand in its file."))

(define (opening-cell exercises)
  (code-cell (format "(require mechanics/answers)\n(exercises\n ~a)" (sealed-pieces exercises))))

(define (check-call names) (format "(check ~a)" (string-join (map symbol->string names))))

;; numbers : exercise -> its number
(define ((part->cells numbers) p)
  (cond [(passage? p) (list (text-cell (question-text (passage-text p))))]
        [(given? p) (list (code-cell (given-source p)))]
        [(exercise? p)
         (list (text-cell (exercise-text p (hash-ref numbers p)))
               (code-cell (format "(define ~a unanswered)\n\n~a" (exercise-name p)
                                  (check-call (list (exercise-name p))))))]
        [else '()]))

(define (exercise-text e number)
  (define unit (setting e 'unit))
  (format "### ~a. ~a (~a)\n\n~a\n\n~a~a, as\n\n    ~a\n\n~a" number
          (Markdown-escaped (symbol->string (exercise-name e))) (points-of e)
          (question-text (exercise-question e))
          (kind-says (kind-of-exercise e)) (if unit (format " in ~a" (Markdown-escaped unit)) "")
          (answer-form e)
          (Markdown-escaped (or (answer-names e) ""))))

;; Parts between backquotes are typeset
(define (question-text text)
  (string-join
   (for/list ([part (in-list (text->parts text))])
     (if (word? part) (Markdown-escaped (word-text part)) (format "$~a$" (tree->TeX part))))))
