#lang racket/base
;; Which values of controls are computed beforehand.

(require racket/list
         mechanics/show/interact/sampling
         "../../support/checks.rkt")

(test-case "all values that there is room for; else every second one, every third one"
  (check-equal? (sampled-positions '(10) '(0) 60) (list (range 10)))
  (check-equal? (sampled-positions '(7) '(0) 4) '((0 2 4 6)))
  (check-equal? (sampled-positions '(101) '(0) 60) (list (range 0 101 2)))
  (check-equal? (sampled-positions '(3 2) '(0 1) 60) '((0 1 2) (0 1))))

(test-case "start, first and last are among them"
  (check-equal? (sampled-positions '(10) '(4) 5) '((0 1 4 7 9)))
  (for* ([n '(5 61 62 100 997)] [start (list 0 (quotient n 3) (- n 1))] [most '(1 2 3 7 60)])
    (define positions (car (sampled-positions (list n) (list start) most)))
    (check-true (<= (length positions) most))
    (check-true (and (member start positions) #t))
    (check-equal? positions (sort (remove-duplicates positions) <))
    (when (>= most 3)
      (check-true (and (member 0 positions) (member (- n 1) positions) #t)))))

(test-case "of many controls the last are left at their start"
  (check-equal? (sampled-positions '(2 2 2) '(0 1 1) 5) '((0 1) (0 1) (1)))
  (define taken (sampled-positions '(100 100 100 100 100 100 100) '(5 5 5 5 5 5 5) 60))
  (check-true (<= (apply * (map length taken)) 60))
  (check-equal? (last taken) '(5)))
