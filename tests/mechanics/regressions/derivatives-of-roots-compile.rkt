#lang racket/base
;; The derivatives of roots and of powers asked whether their base is zero, which ended the
;; trace: a Lagrangian with a distance in it was never compiled.

(require racket/flonum
         mechanics
         "../support/checks.rkt")

(define ((L-orbital mu) (up t q v))
  (+ (* 1/2 (square v)) (/ mu (sqrt (square q)))))

(test-case "equations of motion with a distance are compiled"
  (define code
    (compile-function (Lagrangian->state-derivative (L-orbital 3)) (up 0 (up 1 2) (up 0 1))))
  (check-false (compiled-function-reason code))
  (define slope (code (flvector 0.0 3.0 4.0 0.5 0.25)))
  (for ([x (in-flvector slope)] [expected (in-list '(1.0 0.5 0.25 -0.072 -0.096))])
    (check-= x expected 1e-15)))

(test-case "derivatives of roots and powers are compiled"
  (define (reason f) (compiled-function-reason (compile-function f (up 2 3))))
  (define (at f) (lambda (s) ((D (lambda (x) (f x (ref s 1)))) (ref s 0))))
  (check-false (reason (at (lambda (x y) (sqrt x)))))
  (check-false (reason (at (lambda (x y) (expt x 1/3)))))
  (check-false (reason (at (lambda (x y) (expt y x)))))
  (check-false (reason (at (lambda (x y) (log x)))))
  (check-false (reason (at (lambda (x y) (asin (/ x 4)))))))

(test-case "at zero there is still no derivative"
  (check-exn exn:fail:mechanics:singular? (lambda () ((D sqrt) 0)))
  (check-exn exn:fail:mechanics:singular? (lambda () ((D sqrt) 0.0)))
  (check-equal? ((D (lambda (x) (expt x 0))) 0) 0)
  (define code (compile-function (lambda (s) ((D sqrt) (ref s 0))) (up 1 2)))
  (check-false (< -inf.0 (flvector-ref (code (flvector 0.0 1.0)) 0) +inf.0)))
