#lang racket/base
;; Expressions for parts of expressions.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/substitute
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (substituted d . pairs)
  (expression->datum
   (substitute-expression (datum->expression d)
                          (let loop ([ps pairs])
                            (if (null? ps)
                                '()
                                (cons (cons (datum->expression (car ps))
                                            (datum->expression (cadr ps)))
                                      (loop (cddr ps))))))))

(test-case "symbols and whole subexpressions are replaced, all at once"
  (check-equal? (substituted '(+ (* k (x t)) k) 'k '(* m w)) '(+ (* m w (x t)) (* m w)))
  (check-equal? (substituted '(+ a b) 'a 'b 'b 'a) '(+ b a))
  (check-equal? (substituted '(* 2 (x t)) '(x t) '(cos t)) '(* 2 (cos t)))
  (check-equal? (substituted '(* 2 a) 'a 3) 6)
  (check-equal? (substituted '(f (up a b)) 'a 1) '(f (up 1 b))))
