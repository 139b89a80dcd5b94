#lang racket/base
;; a √(a/b) was shown as √(a³/b), which is its opposite where a is negative, and
;; nothing was said of it.

(require mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/expression
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/expression/read
         "../support/checks.rkt" "../support/evaluate.rkt")

(define (simplified datum [A no-assumptions])
  (define-values (simple notes) (simplify-expression/assumptions (datum->expression datum) A))
  (list (expression->datum simple) notes))

(test-case "what goes under a root is taken not to be negative, and that is said"
  (check-equal? (simplified '(* a (sqrt (/ a b)))) '((sqrt (/ (expt a 3) b)) ((>= a 0))))
  (check-equal? (simplified '(/ k (sqrt (* k m)))) '((sqrt (/ k m)) ((>= m 0)))))

(test-case "even powers, and all of a radicand, may go without"
  (check-equal? (simplified '(* a a (sqrt (/ a b)))) '((sqrt (/ (expt a 5) b)) ()))
  (check-equal? (simplified '(* a (sqrt (* a b)))) '((* a (sqrt (* a b))) ())))

(test-case "where nothing may be taken for granted it stays outside"
  (check-equal? (simplified '(* a (sqrt (/ a b))) (with-automatic-assumptions no-assumptions #f))
                '((* a (sqrt (/ a b))) ())))

(test-case "a number leaves the root of what is not real, as |x| does"
  (check-equal? (simplified '(expt (* 4 (+ 1 (* +i y))) 1/4))
                '((* (expt (+ 1 (* +i y)) 1/4) (sqrt 2)) ()))
  (check-equal? (simplified '(expt (* x x (+ 1 (* +i y))) 1/4)
                            (with-automatic-assumptions no-assumptions #f))
                '((* (expt (+ 1 (* +i y)) 1/4) (sqrt (abs x))) ())))

;; √(z⁴) is z² or its opposite, by the angle of z.
(test-case "a power of what is not real stays under its root"
  (for ([n '(3 4 5 -3)] [q '(4 2 2 4)])
    (define power `(expt (+ a (exp (* +i y))) ,n))
    (define e (datum->expression `(expt ,power ,(/ 1 q))))
    (define-values (simple _) (simplify-expression/assumptions e))
    (for ([y '(0.3 1.7 -2.1)])
      (define (value e) (evaluate-expression e (point-lookup `((a . -0.7) (y . ,y)))))
      (check-= (value simple) (value e) 1e-12 (format "~a, ~a/~a" y n q)))))
