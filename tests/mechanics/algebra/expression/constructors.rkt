#lang racket/base
;; Expressions as they are made: what is neutral drops out, and nothing else is worked out.

(require mechanics/algebra/expression/expression
         "../../support/checks.rkt")

(define (made f a b) (expression->datum (f a b)))

(test-case "powers with a plain value"
  (define x^2 (e:expt 'x 2))
  (check-equal? (map (lambda (n) (made e:expt 'x n)) '(0 1 2 -1 1/2))
                '(1 x (expt x 2) (expt x -1) (expt x 1/2)))
  (check-equal? (map (lambda (b) (made e:expt b 'n)) '(0 1 2)) '((expt 0 n) 1 (expt 2 n)))
  (check-equal? (made e:expt 0 3) 0)
  (check-equal? (made e:expt x^2 3) '(expt x 6))
  (check-equal? (made e:expt x^2 1/2) '(expt (expt x 2) 1/2)))

(test-case "sums, products and quotients with 0, 1 and each other"
  (check-equal? (list (made e:+ 'x 0) (made e:+ 0 'x) (made e:- 'x 0) (made e:- 'x 'x)) '(x x x 0))
  (check-equal? (list (made e:* 'x 1) (made e:* 1 'x) (made e:* 'x 0) (made e:* 0 'x)) '(x x 0 0))
  (check-equal? (list (made e:/ 'x 1) (made e:/ 0 'x) (made e:/ 'x 'x)) '(x 0 1))
  (check-equal? (made e:+ (e:+ 1 'x) (e:+ 'y 2)) '(+ 3 x y))
  (check-equal? (made e:* (e:* 2 'x) (e:* 'y 3)) '(* 6 x y)))
