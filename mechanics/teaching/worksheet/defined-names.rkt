#lang racket/base
;; What a student's program defines, by its text: an answer under a misspelt name is found, and
;; one that is given twice.

(require racket/list
         "exercise.rkt"
         "../../error/spelling.rkt")

(provide definition-notes defined-names)

;; exercises : to be answered; text : a program -> strings, what there is to say
(define (definition-notes exercises text)
  (filter values (for/list ([e (in-list exercises)]) (note-on e exercises text))))

(define (note-on e exercises text)
  (define name (exercise-name e))
  (cond [(> (times-defined name text) 1)
         (format "~a is answered twice; the last answer was judged" name)]
        [(misspelt-name e exercises text)
         => (lambda (near) (format "~a is not defined; ~a is: is that its answer?" name near))]
        [else #f]))

;; Definitions begin their lines. -> symbols
(define (defined-names text)
  (map string->symbol
       (regexp-match* #px"(?m:^\\(define[ \t]+\\(*([^\\s()\";]+))" text #:match-select cadr)))

(define (times-defined name text)
  (count (lambda (n) (eq? n name)) (defined-names text)))

;; e : an exercise that was not answered, of these exercises; text : the program
;; -> the name of what may have been meant for its answer, or #f
(define (misspelt-name e exercises text)
  (define names (defined-names text))
  (define others (remq* (map exercise-name exercises) names))
  (define near (nearest-names (symbol->string (exercise-name e)) (remove-duplicates others)))
  (and (not (memq (exercise-name e) names)) (pair? near) (car near)))
