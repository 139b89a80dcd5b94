#lang racket/base
;; Conditions for an expression to have a value, and relations that are none.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/domain
         mechanics/algebra/assumption/signs
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

;; The relations as ((signs . datum) ...).
(define (domain datum)
  (for/list ([r (in-list (domain-relations (datum->expression datum)))])
    (cons (relation-signs r) (relation-expression r))))

(define (demands . signs+datums)
  (let loop ([rest signs+datums])
    (if (null? rest)
        '()
        (cons (cons (car rest) (datum->expression (cadr rest))) (loop (cddr rest))))))

(test-case "radicands, arguments of logarithms and of inverse functions"
  (check-equal? (domain '(sqrt (- 1 x))) (demands nonnegative '(- 1 x)))
  (check-equal? (domain '(expt (- 1 x) -1/2)) (demands positive '(- 1 x)))
  (check-equal? (domain '(log (* x y))) (demands positive '(* x y)))
  (check-equal? (domain '(asin x)) (demands nonnegative '(+ x 1) nonnegative '(- 1 x)))
  (check-equal? (domain '(acosh x)) (demands nonnegative '(- x 1))))

(test-case "inner ones come first"
  (check-equal? (domain '(log (sqrt x))) (demands nonnegative 'x positive '(sqrt x))))

(test-case "what holds everywhere demands nothing"
  (check-equal? (domain '(sqrt (+ (* x x) (expt y 2)))) '())
  (check-equal? (domain '(sqrt (* (- x a) (- x a)))) '())
  (check-equal? (domain '(/ 1 (sqrt (+ 2 (cos x))))) '())
  (check-equal? (domain '(log (+ 1 (exp x)))) '())
  (check-equal? (domain '(sqrt (+ (* x x) y))) (demands nonnegative '(+ (* x x) y)))
  (check-equal? (domain '(expt x 1/3)) (demands nonnegative 'x)))

(test-case "a sum of squares under a root in the denominator is not 0"
  (check-equal? (domain '(expt (+ (* x x) (* y y)) -1/2))
                (demands positive '(+ (* x x) (* y y)))))

(test-case "integer powers, symbolic powers and complex values demand nothing"
  (check-equal? (domain '(expt x -3)) '())
  (check-equal? (domain '(expt x n)) '())
  (check-equal? (domain '(* +i (sqrt x))) '()))
