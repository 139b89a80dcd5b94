#lang racket/base
;; √(cd) = √(−c) √(−d) was proved without a word, and holds nowhere among positive numbers.

(require mechanics
         "../support/checks.rkt")

(define x 'x)

(test-case "a proof tells where both sides are real, if that is not among positive numbers"
  (define (remarks a b) (verdict-remarks (verify-equal a b)))
  (check-equal? (remarks (sqrt (* 'c 'd)) (* (sqrt (- 'c)) (sqrt (- 'd))))
                '("both sides are real where (>= (* -1 c) 0), (>= (* -1 d) 0)"))
  (check-equal? (remarks (log (square x)) (* 2 (log (- x))))
                '("both sides are real where (> (* -1 x) 0)"))
  (check-equal? (remarks (log (square x)) (* 2 (log x))) '())
  (check-equal? (remarks (+ (asin x) (acos x)) (/ ':pi 2)) '())
  (assuming ('(< x 0)) (check-equal? (remarks (log (square x)) (* 2 (log (- x)))) '())))
