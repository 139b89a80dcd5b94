#lang racket/base
;; The definitions in the text of a student's program: an answer under a misspelt name is found,
;; and an answer that is given twice.

(require racket/list
         "exercise.rkt"
         "../../error/spelling.rkt")

(provide definition-notes defined-names defined-numbers)

;; exercises : to be answered; text : a program -> notes, texts
(define (definition-notes exercises text)
  (filter-map (lambda (e) (note-on e exercises text)) exercises))

;; -> text, or #f
(define (note-on e exercises text)
  (define name (exercise-name e))
  (define names (defined-names text))
  (case (count (lambda (n) (eq? n name)) names)
    [(0)
     (define others (remove-duplicates (remq* (map exercise-name exercises) names)))
     (define near (nearest-names (symbol->string name) others))
     (and (pair? near)
          (format "~a is not defined; ~a is: is that its answer?" name (car near)))]
    [(1) #f]
    [else (format "~a is answered twice; the last answer was judged" name)]))

;; Definitions begin their lines. -> symbols
(define (defined-names text)
  (map string->symbol
       (regexp-match* #px"(?m:^\\(define[ \t]+\\(*([^\\s()\";]+))" text #:match-select cadr)))
;; -> pairs of a name and its number
(define (defined-numbers text)
  (define number #px"(?m:^\\(define[ \t]+([^\\s()\";]+)[ \t]+([^\\s()\";]+)[ \t]*\\))")
  (for*/list ([m (in-list (regexp-match* number text #:match-select cdr))]
              [x (in-value (string->number (cadr m)))]
              #:when (rational? x))
    (cons (string->symbol (car m)) x)))
