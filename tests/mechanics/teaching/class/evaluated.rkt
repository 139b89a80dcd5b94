#lang racket/base
;; A submission evaluated in this process, as its own does it: answers by name, and what runs too
;; long.

(require mechanics/teaching/class/collect-answers
         mechanics/teaching/class/evaluate
         mechanics/teaching/worksheet/make-exercise
         "../../support/checks.rkt" "../../support/patience.rkt")

(define exercises
  (for/list ([name '(first second third)]) (make-exercise name 'expression "?" '((key k)))))

(define (evaluated seconds text)
  (define out (open-output-string))
  (define asked (format "~s" (request seconds 512 exercises text #f)))
  (evaluate-request (open-input-string asked) out #f)
  (collected-from (get-output-string out) 'done))

(test-case "answers have the names of their exercises"
  (define c (evaluated #f "#lang mechanics\n(define second (* 2 'k))\n(define first 'k)\n"))
  (check-false (collected-problem c))
  (check-equal? (collected-answers c)
                (hasheq 'first '(answer k) 'second '(answer (* 2 k)) 'third '(unanswered))))

(test-case "a definition that fails costs its own answer, and no other"
  (define found
    (collected-answers
     (evaluated #f "#lang mechanics\n(define first (/ 1 0))\n(define second 'k)\n")))
  (check-regexp-match #rx"division by zero" (cadr (hash-ref found 'first)))
  (check-equal? (hash-ref found 'second) '(answer k)))

(test-case "a program that runs too long is ended after its seconds"
  (define c (evaluated (processor-seconds 1) "#lang mechanics\n(let loop () (loop))\n"))
  (check-regexp-match #rx"^it does not run: " (collected-problem c)))
