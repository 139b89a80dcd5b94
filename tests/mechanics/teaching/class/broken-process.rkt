#lang racket/base
;; A process that cannot be started, or that writes what none of ours would: each costs only
;; itself.

(require mechanics/teaching/class/collect-answers
         mechanics/teaching/class/grade
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         "../../support/checks.rkt" "../../support/evaluated-here.rkt")

(define w
  (make-worksheet "Broken" #f "broken"
                  (list (make-exercise 'frequency 'expression "?" '((key k))))))

(define (submission-of id) (submission id id "#lang mechanics\n(define frequency 1)\n" #f #f #f))

(define no-process
  (make-security-guard (current-security-guard)
                       (lambda (who path uses)
                         (when (memq 'execute uses) (error who "no process is left")))
                       void))

(test-case "where no process can be started the class is graded to its end"
  (define report
    (parameterize ([current-security-guard no-process])
      (grade-class w (map submission-of '("a" "b")) #:strictest 'own)))
  (check-true (class-report? report))
  (for ([g (in-list (class-report-graded report))])
    (check-regexp-match #rx"^it could not be evaluated: .*no process is left" (graded-problem g))
    (check-equal? (map judgment-status (graded-judgments g)) '(failed))))

(test-case "what a process says of its program is believed in one form alone"
  (define (problem-of line) (collected-problem (collected-from (string-append line "\n") 'done)))
  (check-equal? (problem-of "(*program* failed 111 104)") "it does not run: oh")
  (for ([line '("(*program* unanswered)" "(*program* answer x)" "(*program* text 111)"
                "(*program* answer)" "(*program*)")])
    (check-pred string? (problem-of line) line)
    (check-false (regexp-match? #rx"does not run: [ox]" (problem-of line)) line)))

(test-case "of a program that cannot be read it is told why"
  (define report
    (grade-class w (list (submission "a" "a" "#lang mechanics\n(define frequency" #f #f #f))
                 #:strictest 'own #:collect (collect-here-if (lambda (id) #t))))
  (check-regexp-match #rx"^it does not run: .*expected a `[)]`"
                      (graded-problem (car (class-report-graded report)))))
