#lang racket/base
;; √a² √b² is −a b where a b < 0, whatever the signs of a and b: these are no assumptions, but the
;; declaration is one.  The proof was told to rest on nothing.

(require mechanics "../support/checks.rkt")

(define (told x) (verdict-assumptions (assuming ('(< (* a b) 0)) (prove-zero x))))

(test-case "a proof by a declaration names it"
  (define x (+ (* 'a 'b) (* (sqrt (square 'a)) (sqrt (square 'b)))))
  (check-equal? (told x) '((< (* a b) 0)))
  (check-equal? (told (+ (/ (abs 'a) 'a) (/ (sqrt (square 'b)) 'b))) '((< (* a b) 0))))
