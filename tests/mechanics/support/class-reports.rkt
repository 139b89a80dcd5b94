#lang racket/base
;; Reports on classes made of answers as data, without processes.

(require mechanics/teaching/class/class-list
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/exercise
         mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment)

(provide report-of)    ; (report-of worksheet class (id person answer ...) ...)

;; An answer is data, for each exercise of the worksheet.
(define (report-of w class . students)
  (class-report
   w #f
   (for/list ([s (in-list students)])
     (define handed-in (submission (car s) (cadr s) "" #f #f #f))
     (define owners (participants-of class handed-in))
     (graded handed-in
             (for/list ([e (in-list (exercises-of w))] [d (in-list (cddr s))])
               (judged e d (judge e d)))
             #f '() (and (= 1 (length owners)) (car owners)) 1))
   class '()))
