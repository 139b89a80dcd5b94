#lang racket/base
;; A proof by the range of an arc rested on declared bounds without a word.

(require mechanics
         "../support/checks.rkt")

(define (grounds claim) (verdict-assumptions (assuming ('(> x 0) '(< x 1)) (claim))))

(test-case "what was declared of the symbols is told"
  (for ([claim (list (lambda () (verify-equal (acos (cos 'x)) 'x))
                     (lambda () (verify-equal (asin (sin 'x)) 'x)))])
    (check-equal? (grounds claim) '((> x 0) (< x 1)))
    (check-true (proved? (assuming ('(> x 0) '(< x 1)) (claim))))
    (check-true (refuted? (claim)))))

(test-case "what is said of others is not"
  (assuming ('(> y 0) '(> x 0) '(< x 1))
    (check-equal? (verdict-assumptions (verify-equal (acos (cos 'x)) 'x)) '((> x 0) (< x 1)))))
