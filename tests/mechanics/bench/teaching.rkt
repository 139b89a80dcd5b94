#lang racket/base
;; A class: thirty submissions of a worksheet with five exercises, judged.

(require "task.rkt"
         mechanics/worksheet/class/grade mechanics/worksheet/class/submission
         mechanics/worksheet/student-file
         racket/runtime-path
         racket/string)

(provide teaching-tasks)

(define-runtime-path pendulum "../../../examples/mechanics/worksheets/pendulum.rkt")

;; What each answers, different in each, so that each has to be judged.
(define (answers n)
  (hash "L-bob" (format "(lambda ((up t a b)) (+ (* ~a 'm (square (* 'l b))) (* 'm 'g 'l (cos a))))"
                        (/ (+ n 1) 2))
        "motion" (format "(lambda (theta t) (+ (* ~a (((expt D 2) theta) t)) (sin (theta t))))" n)
        "constant" (format "(lambda ((up t a b)) (- (* ~a (square (* 'l b))) (* 'g 'l (cos a))))"
                           (/ n 2))
        "period" (format "~a" (/ n 10.0))
        "why" "\"It cancels.\""))

(define (submissions w)
  (define text (worksheet->student-file w))
  (for/list ([n (in-range 1 31)])
    (define id (number->string n))
    (submission id id
                (for/fold ([text text]) ([(name answer) (in-hash (answers n))])
                  (string-replace text (format "(define ~a unanswered)" name)
                                  (format "(define ~a ~a)" name answer)))
                #f)))

(define (prepare)
  (define w (dynamic-require pendulum 'worksheet))
  (cons w (submissions w)))

(define teaching-tasks
  (list
   (make-prepared-task
    'class30 "thirty submissions of five exercises, each in its process, judged"
    prepare
    (lambda (p) (grade-class (car p) (cdr p)))
    #:size (lambda (r)
             (define failed
               (for/sum ([g (in-list (class-report-graded r))]) (if (graded-problem g) 1 0)))
             (format "~a of ~a ran" (- 30 failed) (length (class-report-graded r)))))))
