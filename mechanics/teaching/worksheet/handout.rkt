#lang racket/base
;; The page to hand out: questions with formulas typeset, given definitions, and for the teacher
;; the key.
;;
;; In a question, backquotes enclose a formula, written as an answer is: "Show that `(/ g l)` is
;; the square of a frequency."

(require racket/list
         (only-in racket/string string-trim)
         "exercise-kind.rkt" "exercise.rkt" "judgment-words.rkt"
         "../../algebra/notation/tree.rkt"
         "../../show/document/document-piece.rkt" "../../show/document/shown-result.rkt"
         "../../generic/value-tree.rkt"
         "../../value/read-expression.rkt" "../../value/simplify.rkt")

(provide worksheet->document text->parts)

;; answers? : with the keys
(define (worksheet->document w #:answers? [answers? #f])
  (document
   (worksheet-title w)
   #f
   (append (if (worksheet-due w) (list (line (format "Due: ~a" (worksheet-due w)))) '())
           (part-pieces w answers?)
           (list (line (format "In all ~a." (counted-points (total-points (exercises-of w)))))))))

(define (line text) (prose (list (list text))))

(define (part-pieces w answers?)
  (define numbers (numbered-exercises w))
  (append*
   (for/list ([p (in-list (worksheet-parts w))])
     (cond [(passage? p) (list (apply paragraph (text->parts (passage-text p))))]
           [(given? p) (list (code (given-source p) 1))]
           [(formula? p)
            (list (paragraph (word (formula-label p)) (value->tree (formula-value p) #t)))]
           [else (append (question-pieces p (hash-ref numbers p))
                         (if answers? (answer-pieces p) '()))]))))

(define (question-pieces e number)
  (define unit (setting e 'unit))
  (define note (format "(~a~a)" (if unit (format "in ~a; " unit) "") (points-of e)))
  (list (heading (format "~a. ~a" number (exercise-name e)))
        (apply paragraph (append (text->parts (exercise-question e)) (list (word note))))))

(define (answer-pieces e)
  (cons (paragraph (word "Key:") (key-tree e))
        (append
         (for/list ([s (in-list (exercise-slips e))])
           (paragraph (word "Slip:") (datum-tree (slip-datum s)) (word (slip-message s))))
         (for/list ([h (in-list (exercise-hints e))])
           (apply paragraph (word "Hint:") (text->parts (hint-text h)))))))

(define (key-tree e)
  (cond [(exercise-key e) => datum-tree]
        [else (word (format "none; ~a" (kind-says (kind-of-exercise e))))]))

;; Keys are shown simplified.
(define (datum-tree d)
  (value->tree (simplify-strictly (read-expression d)) #t))

;; Words and formulas in a line, as a report, which all renderers know.
(define (paragraph . parts)
  (result (shown-formula (report (list (report-line 0 "" parts))) '())))

;; text -> words and trees.  Characters that touch a formula, such as a comma, belong to it.
(define (text->parts text)
  (define pieces (regexp-match* #px"`[^`]*`[^\\s`]*|[^`]+" (regexp-replace* #px"\\s+" text " ")))
  (for/list ([piece (in-list pieces)] #:unless (string=? piece " "))
    (define m (regexp-match #rx"^`(.*)`([^`]*)$" piece))
    (cond [(not m) (word (string-trim piece))]
          [(string=? "" (caddr m)) (formula-in-text (cadr m))]
          [else (row (list (formula-in-text (cadr m)) (word (caddr m))))])))

;; Text that cannot be read stays text.
(define (formula-in-text text)
  (with-handlers ([exn:fail? (lambda (e) (plain text))])
    (value->tree (read-expression text) #t)))
