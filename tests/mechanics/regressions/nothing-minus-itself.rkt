#lang racket/base
;; a - a was 0 before anyone could see that a has no value anywhere, and a/a was 1; and an
;; indirect proof took signs at a point of its own, so that a statement and its opposite were
;; both proved, each under assumptions of its own.

(require mechanics "../support/checks.rkt")

(test-case "what has no value is not equal to itself"
  (for ([a (list (sqrt (- (atan 'y) 2)) (log (- -1 (square 'x)))
                 (/ 1 (- (square (sin 'x)) (- 1 (square (cos 'x))))))])
    (check-equal? (verdict-reason (prove-zero (- a a))) 'nowhere-defined)
    (check-false (proved? (prove-zero (- (/ a a) 1))))))

(test-case "what has one somewhere is, and shown as 0"
  (check-true (proved? (prove-zero (- (sqrt 'x) (sqrt 'x)))))
  (check-equal? (expression (simplify (- (log 'x) (log 'x)))) 0)
  (check-equal? (expression (- 'a 'a)) 0)
  (check-equal? (expression (/ (square 'a) (square 'a))) 1))

(define l (* (* (sqrt (/ 2 (- 'a 3))) (sqrt (/ 'z 'y))) (sqrt (- 1 (exp 'x)))))
(define r
  (- (* (* (sqrt (/ 2 (- 'a 3))) (/ (sqrt (* 'z 'y)) 'y)) (expt (- (- (exp 'x) 1)) 1/2))))

(test-case "a statement and its opposite are not both proved"
  (check-false (and (proved? (prove-zero (- l r))) (proved? (prove-zero (+ l r)))))
  (check-equal? (verdict-assumptions (prove-zero (+ l r))) '((>= y 0))))
