#lang racket/base
;; Hyperbolic functions of logarithms were not powers; and of log(1 - a) and
;; log((1 - a)²) one took a to be below 1, the other above.  Where log(1 - a) has a value,
;; a is below 1, and nothing is assumed.

(require mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         "../support/checks.rkt")

(define (simplified datum)
  (define-values (simple notes) (simplify-expression/assumptions (datum->expression datum)))
  (list (expression->datum simple) notes))

(test-case "hyperbolic functions of logarithms are rational"
  (check-equal? (car (simplified '(+ (cosh (log a)) (sinh (log a))))) 'a)
  (check-equal? (car (simplified '(- (tanh (log a)) (/ (- (* a a) 1) (+ (* a a) 1))))) 0)
  (check-equal? (car (simplified '(- (cosh (+ b (log a)))
                                     (/ (+ (* a (exp b)) (/ 1 (* a (exp b)))) 2))))
                0))

(test-case "a square has the logarithm of what stands beside it"
  (check-equal? (simplified '(- (* 1/2 (log (expt (- 1 a) 2))) (log (- 1 a))))
                '(0 ()))
  (check-equal? (simplified '(- (* 1/2 (log (expt (- 1 a) 2))) (log (- a 1))))
                '(0 ())))
