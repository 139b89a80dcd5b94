#lang racket/base
;; Numbers for expressions.

(require rackunit
         mechanics/algebra/expression/evaluate
         mechanics/algebra/expression/read)

(define (value d point)
  (evaluate-expression (datum->expression d)
                       (point-lookup (for/list ([entry (in-list point)])
                                       (cons (datum->expression (car entry)) (cdr entry))))))

(test-case "expressions are evaluated exactly where numbers are exact"
  (check-equal? (value '(/ (+ a (* 2 b)) (expt a 2)) '((a . 3) (b . 1/2))) 4/9)
  (check-= (value '(sin (* 2 a)) '((a . 1))) (sin 2) 1e-15))

(test-case "a literal function is known by the values of its arguments"
  (check-equal? (value '(- (V (+ t t)) (V (* 2 t))) '((t . 1) ((V 2) . 7))) 0)
  (check-equal? (value '(V (x t)) '((t . 1) ((x t) . 2) ((V 2) . 9))) 9)
  (check-equal? (value '((D x) t) '((t . 1) ((x t) . 2) (((D x) t) . 5))) 5)
  (check-equal? (value '(F (up t (* 2 t))) '((t . 1) ((F (up 1 2)) . 3))) 3))

(test-case "a point that leaves something out is an error naming it"
  (check-exn #rx"gives it no value.*\\(V 2\\)"
             (lambda () (value '(V 2) '((t . 1))))))
