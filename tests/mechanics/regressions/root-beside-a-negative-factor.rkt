#lang racket/base
;; The root of a negative number times a root was split into two, of which one had no value
;; anywhere: √(-2√x), which is 0 at x = 0, became √-2 x^(1/4).

(require mechanics
         (only-in mechanics/algebra/expression/read datum->expression)
         "../support/checks.rkt")

(define (shown datum) (expression (simplify (datum->expression datum))))

(test-case "a root stays beside what is negative"
  (for ([datum '((sqrt (* -2 (sqrt x)))
                 (sqrt (* (- (cos z) 2) (sqrt (- x (expt x 2)))))
                 (expt (* (- (cos z) 2) (sqrt (- x (expt z 2)))) 1/4))])
    (check-equal? (shown datum) datum)
    (check-equal? (simplify (substitute (datum->expression datum) 'x 0 'z 0)) 0)))

(test-case "and leaves what is positive or unknown, as ever"
  (check-equal? (shown '(sqrt (* 2 (sqrt x)))) '(* (expt x 1/4) (sqrt 2)))
  (check-equal? (shown '(sqrt (* (- 2 (cos z)) (sqrt x)))) '(* (expt x 1/4) (sqrt (- 2 (cos z)))))
  (check-equal? (shown '(sqrt (* y (sqrt x)))) '(* (expt x 1/4) (sqrt y))))
