#lang racket/base
;; A witness named what the residual depends on.  With another number for what had cancelled the
;; expression may have no value, and nothing is refuted there.

(require mechanics "../support/checks.rkt")

(define (names x) (map (lambda (entry) (expression (car entry))) (verdict-witness (prove-zero x))))

(test-case "what decides whether there is a value is named"
  (check-equal? (names (+ 'a (- (log 'b) (log (/ (* 'b 'c) 'c))))) '(a b c))
  (check-equal? (names (+ 'a (/ (- 'c (* 1/2 (+ 'c 'c))) (sqrt 'b)))) '(a b))
  (check-equal? (names (+ 1 (* 0 'a) (- (sqrt 'b) (* 1/2 (+ (sqrt 'b) (sqrt 'b)))))) '(b)))

(test-case "what only cancels is not"
  (check-equal? (names (+ 'a (- (square (+ 'b 'c)) (square 'b) (square 'c) (* 2 'b 'c)))) '(a))
  (check-equal? (names (- (sin 'a) (/ (+ 'c 'b (- 'c)) 'd) (/ (- 'b) 'd) 2)) '(a d)))
