#lang racket/base
;; Helpers of the tests that could be wrong themselves: numbers that are close, values of
;; expressions.

(require mechanics/algebra/expression/read
         "support/checks.rkt" "support/close.rkt" "support/evaluate.rkt")

(test-case "numbers are close relative to the greater, and to 1"
  (check-true (close? 1e20 (+ 1e20 1e10)))
  (check-false (close? 1e20 (+ 1e20 1e12)))
  (check-true (close? 0 1e-10))
  (check-true (close? 1.0+2.0i 1.0+2.0000000001i))
  (check-false (close? 1.0+2.0i 1.0-2.0i)))

(test-case "what is not finite is close to itself alone"
  (define unlike (list +inf.0 -inf.0 +nan.0 1.0 0 +inf.0+1.0i 1.0+nan.0i))
  (for* ([a unlike] [b unlike])
    (check-equal? (close? a b) (eqv? a b) (format "~a ~a" a b))))

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
