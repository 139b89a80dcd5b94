#lang racket/base
;; A submission whose answers take too long to judge costs no other.

(require (prefix-in m: mechanics)
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         "../../support/checks.rkt" "../../support/patience.rkt")

(define w
  (make-worksheet
   "Slow" #f "slow"
   (list (make-exercise 'first 'expects "?"
                        (list (list 'expects
                                    (lambda (x) (if (m:= x 'slow) (let loop () (loop)) #t)))))
         (make-exercise 'second 'expression "?" '((key k)))
         (make-exercise 'third 'expression "?" '((key l))))))

(define (submission-of id answer)
  (submission id id
              (format (string-append "#lang mechanics\n(define first '~a)\n"
                                     "(define-values (second third) (values '~a '~a))\n")
                      answer id id)
              #f #f #f))

(test-case "what is long to judge is left to a person, with what follows it in that submission"
  (define r (grade-class w (list (submission-of "k" "quick") (submission-of "l" "slow")
                                 (submission-of "k" "slow"))
                         #:seconds (processor-seconds 2)))
  (check-equal? (for/list ([g (in-list (class-report-graded r))])
                  (map judgment-status (graded-judgments g)))
                '((right right wrong) (undecided undecided undecided) (undecided right wrong))
                (format "~s" (map graded-problem (class-report-graded r))))
  (check-equal? (judgment-words (car (graded-judgments (cadr (class-report-graded r)))))
                '("to judge it took too long, or too much memory")))

;; Of the seconds the judgment takes six tenths and the program, which may take two thirds, nearly
;; half: room is left for what either needs besides.
(test-case "the time that a program took is none for its judgment"
  (define seconds (processor-seconds 2))
  (define (milliseconds) (current-process-milliseconds (current-thread)))
  (define (look _)
    (define end (+ (milliseconds) (* 600 seconds)))
    (let loop () (or (> (milliseconds) end) (loop))))
  (define works
    (make-worksheet "Works" #f "works"
                    (list (make-exercise 'first 'expects "?" `((expects ,look))))))
  (define (status-of program)
    (define text (format "#lang mechanics\n~s\n(define first 1)\n" program))
    (define r (grade-class works (list (submission "s" "s" text #f #f #f)) #:seconds seconds))
    (judgment-status (car (graded-judgments (car (class-report-graded r))))))
  (check-equal? (status-of '(define second 2)) 'right)
  (check-equal? (status-of `(let* ([now current-process-milliseconds]
                                   [end (+ (now) ,(* 450 seconds))])
                              (let loop () (when (< (now) end) (loop)))))
                'undecided))
