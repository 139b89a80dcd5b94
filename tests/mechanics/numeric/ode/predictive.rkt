#lang racket/base
;; The lengths of steps that are proposed from the last two errors.

(require rackunit
         mechanics/numeric/ode/predictive)

(test-case "a rejected step is tried shorter, never below a fifth"
  (for ([error (in-list '(1.0001 2.0 100.0 1e30))])
    (define next ((make-controller 10) 1.0 error 3))
    (check-true (<= 0.2 next 0.9) (format "~a" next))))

(test-case "the first accepted step decides by its own error, with a tenth to spare"
  (check-= ((make-controller 10) 1.0 (expt 0.5 4) 1) 1.8 0.1)
  (check-= ((make-controller 10) 2.0 1.0 1) 1.8 0.1)
  (check-= ((make-controller 10) 1.0 0.0 1) 8.0 1e-12))

;; Where the error of a step h at the n-th step is c(n) h^4.
(define (lengths c count)
  (define control (make-controller 10))
  (for/fold ([h 1.0] [lengths '()] #:result (reverse lengths)) ([n (in-range count)])
    (define error (* (c n) h h h h))
    (values (control h error 2) (cons (cons h error) lengths))))

(test-case "constant errors lead to constant steps"
  (for ([step (in-list (list-tail (lengths (lambda (n) 1e-3) 20) 5))])
    (check-= (car step) (* 0.9 (expt 1e3 1/4)) 0.4)
    (check-true (<= (cdr step) 1.0))))

(test-case "errors that grow steadily are foreseen: no step is rejected"
  (for ([step (in-list (list-tail (lengths (lambda (n) (* 1e-3 (expt 2.0 n))) 40) 8))])
    (check-true (< 0.1 (cdr step) 1.0) (format "~a" step))))

(test-case "slow iterations make steps shorter"
  (check-true (< ((make-controller 10) 1.0 0.5 10) ((make-controller 10) 1.0 0.5 1))))

(test-case "after a rejected step the next one is not longer"
  (define control (make-controller 10))
  (control 1.0 3.0 2)
  (check-true (<= (control 0.5 1e-6 2) 0.5))
  (check-true (> (control 0.5 1e-6 2) 0.5)))
