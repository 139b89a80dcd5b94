#lang racket/base
;; (atan z), (asin z), (sgn z) and (acos (+ 1 z)) stayed in what they were where z vanishes
;; only when it is simplified.

(require mechanics "../support/checks.rkt")

(define zero (- (square (sin 'x)) (- 1 (square (cos 'x)))))

(define-syntax-rule (check-values [expression value] ...)
  (begin (check-equal? (simplify expression) value) ...))

(test-case "functions of what vanishes"
  (check-values [(atan zero) 0]
                [(asin zero) 0]
                [(sgn zero) 0]
                [(acos (+ 1 zero)) 0]
                [(asinh zero) 0]
                [(atanh zero) 0]
                [(acosh (+ 1 zero)) 0]
                [(atan zero 1) 0]
                [(atan zero (+ 2 zero)) 0]
                [(* 'y (+ 1 (atan zero))) 'y]
                [((literal-function 'f) (atan zero)) ((literal-function 'f) 0)]))

(test-case "signs of numbers"
  (check-values [(sgn (- zero 3)) -1]
                [(sgn (+ zero 1/3)) 1]))

(test-case "what has no exact value stays a function"
  (for ([e (list (atan (+ zero 1)) (asin (+ zero 1)) (acos zero) (atan zero -1)
                 (atan zero zero) (atan zero 'y) (sgn 'x))])
    (check-false (number? (simplify e)))))

(test-case "proved, not only shown"
  (check-true (proved? (prove-zero (atan zero))))
  (check-true (proved? (prove-zero (- (sgn (+ 2 zero)) 1))))
  (check-true (refuted? (prove-zero (- (sgn (- zero 2)) 1)))))
