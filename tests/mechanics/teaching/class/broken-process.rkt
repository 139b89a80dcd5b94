#lang racket/base
;; A process that cannot be started, or that writes what none of ours would: each costs only
;; itself.

(require mechanics/teaching/class/answer-lines
         mechanics/teaching/class/collect-answers
         mechanics/teaching/class/evaluate
         mechanics/teaching/class/grade
         mechanics/teaching/class/process-cost
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

;; Nothing is run where answers come from elsewhere.
(test-case "after each submission the number of those graded is told; equal answers are judged once"
  (define-values (told judged) (values '() 0))
  (define (expect x) (set! judged (+ judged 1)) #t)
  (define w (make-worksheet "Once" #f "once"
                            (list (make-exercise 'frequency 'expects "?" `((expects ,expect))))))
  (define (collect i exercises s) (collected (hasheq 'frequency '(answer k)) #f 0 #f))
  (define report
    (parameterize ([current-security-guard no-process])
      (grade-class w (map submission-of '("a" "b" "c")) #:strictest 'own #:collect collect
                   #:tell (lambda (n) (set! told (cons n told))))))
  (check-equal? (list told judged) '((3 2 1) 1))
  (check-equal? (map graded-points (class-report-graded report)) '(1 1 1)))

(test-case "all answers of a submission are judged, and stand in the order of the exercises"
  (define (asked name) (make-exercise name 'expression "?" '((key k))))
  (define (collect i exercises s)
    (collected (hasheq 'second '(answer (* 1 k)) 'first '(answer k)) #f 0 #f))
  (define report
    (parameterize ([current-security-guard no-process])
      (grade-class (make-worksheet "Two" #f "two" (map asked '(first second)))
                   (list (submission-of "a")) #:strictest 'own #:collect collect)))
  (define answers (graded-answers (car (class-report-graded report))))
  (check-equal? (map judged-name answers) '(first second))
  (check-equal? (map judged-status answers) '(right right)))

(test-case "an evaluator learns from an exercise to what an answer is applied"
  (define asked (make-exercise 'radius 'expression "?" '((key r) (arguments r))))
  (define report
    (parameterize ([current-security-guard no-process])
      (grade-class (make-worksheet "One" #f "one" (list asked))
                   (list (submission "a" "a" "#lang mechanics\n(define (radius x) x)\n"
                                     #f #f #f))
                   #:strictest 'own #:collect (collect-here-if (lambda (id) #t)))))
  (check-equal? (map judgment-status (graded-judgments (car (class-report-graded report))))
                '(right)))

(test-case "what a process writes is read to its end, to a bound, or until it costs too much"
  (define (ending size step)
    (define (read-on last) (struct-copy reading last [clock (+ step (reading-clock last))]))
    (call-with-values
     (lambda () (read-within 5 (open-input-bytes (make-bytes size 97)) (reading 0 0 0) read-on))
     list))
  (check-equal? (ending 100000 0) (list (make-string 100000 #\a) 'done 0))
  (check-eq? (cadr (ending 300000 0)) 'long)
  (define after-loading 10)
  (check-equal? (cdr (ending 200000 10)) (list 'late after-loading)))

(test-case "a line that cannot be read is a failed answer, where it says of which exercise"
  (check-equal? (read-answer-lines "#oops\n(x answer #(1))\n(y answer k)\n")
                (hasheq 'x '(failed "there is a name or a number in it that is none")
                        'y '(answer k))))

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
  (check-regexp-match #rx"^Submissions were run in your name" (class-report-warning report))
  (check-regexp-match #rx"^it does not run: .*expected a `[)]`"
                      (graded-problem (car (class-report-graded report)))))

;; Without the limit it would end by itself, without a problem.
(test-case "where its cost is not watched from outside a program is stopped after its seconds"
  (define r (request 1/2 512 '() "#lang racket/base\n(sleep 5)\n" #f))
  (define out (open-output-string))
  (evaluate-request (open-input-string (format "~s\n" r)) out void)
  (check-regexp-match #rx"^it does not run: .*too long"
                      (or (collected-problem (collected-from (get-output-string out) 'done)) "")))
