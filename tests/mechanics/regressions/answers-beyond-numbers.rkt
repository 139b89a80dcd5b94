#lang racket/base
;; An answer in which an infinity or what is no number stands was left to the teacher, or called
;; trivial: +nan.0 as a Lagrangian, for "its equations of motion are 0 = 0".

(require (except-in mechanics time)
         mechanics/teaching/worksheet/answer-data mechanics/teaching/worksheet/judge
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         "../support/checks.rkt")

(define (L s) (- (* 1/2 'm (square (velocity s))) (* 1/2 'k (square (coordinate s)))))

(define asked
  (list (make-exercise 'L 'Lagrangian "?" (list '(coordinates x) (list 'key L)))
        (make-exercise 'motion 'equations "?" (list '(coordinates x) (list 'of L)))
        (make-exercise 'kept 'conserved "?" (list '(coordinates x) (list 'of L)
                                                  (list 'key (Lagrangian->energy L))))
        (make-exercise 'period 'number "?" (list (list 'key 2)))))

(test-case "is no answer, of whatever kind"
  (for* ([e (in-list asked)] [odd (list +nan.0 +inf.0 -inf.0 (make-rectangular 1.0 +inf.0))])
    (define d (answer->datum (* odd 'x) '()))
    (check-equal? (car d) 'failed)
    (check-regexp-match #rx"in it is no number$" (cadr d))
    (check-equal? (judgment-status (judge e d)) 'failed)
    ;; whoever wrote the line
    (check-equal? (judgment-status (judge e (list 'answer odd))) 'failed)))

(test-case "large numbers and small ones are some"
  (for ([x (list 1e300 -1e-300 0.0 (expt 10 400) 1/3)])
    (check-equal? (car (answer->datum x '())) 'answer)))
