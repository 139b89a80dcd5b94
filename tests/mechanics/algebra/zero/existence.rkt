#lang racket/base
;; Where an expression has a value, and which leaves decide that.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/zero/existence
         "../../support/checks.rkt")

(define (somewhere? d [relations '()])
  (somewhere-defined? (expression->tape (datum->expression d))
                      (declare-relations no-assumptions relations)))

(test-case "roots, quotients and logarithms of what is positive with its leaves"
  (check-true (somewhere? '(sqrt (/ k m))))
  (check-true (somewhere? '(/ 1 (+ x (* 2 (sqrt y)) (exp (V x))))))
  (check-true (somewhere? '(expt (* :pi r) (- a b))))
  (check-true (somewhere? '(log (cosh (* g t))))))

(test-case "others are looked at where they may have a value"
  (check-true (somewhere? '(sqrt (- x y 10))))
  (check-true (somewhere? '(/ 1 (- x y))))
  (check-true (somewhere? '(asin (/ x (+ 1 x)))))
  (check-true (somewhere? '(sqrt (* -1 m)) '((< m 0)))))

(test-case "and have one nowhere where a part of them has none"
  (check-false (somewhere? '(log (- -1 (expt x 2)))))
  (check-false (somewhere? '(sqrt (/ -1 (+ (expt x 2) (expt y 4))))))
  (check-false (somewhere? '(* y (sqrt (- (sin x) 2)))))
  (check-false (somewhere? '(sqrt m) '((< m 0))))
  (check-false (somewhere? '(+ x +nan.0))))

;; A complex value is asked for nothing.
(test-case "of a question's expressions those matter that may lack a real value"
  (define asked
    (map datum->expression
         '(3 x (sin x) (sqrt x) (exp (* +i t)) (/ 1 (- x y)) (sqrt (* +i t)))))
  (check-equal? (domain-expressions (append asked asked))
                (list (list-ref asked 3) (list-ref asked 5))))
