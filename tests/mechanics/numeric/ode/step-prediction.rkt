#lang racket/base
;; The lengths of steps that are proposed from the last two errors.

(require mechanics/numeric/ode/step-prediction "../../support/checks.rkt")

(test-case "a rejected step is tried shorter, never below a fifth"
  (for ([error (in-list '(1.0001 2.0 100.0 1e30))])
    (define next ((make-controller 10) 1.0 error 3))
    (check-true (<= 0.2 next 0.9) (format "~a" next))))

(test-case "the first accepted step decides by its own error, with a tenth to spare"
  (check-= ((make-controller 10) 1.0 (expt 0.5 4) 1) 1.8 0.1)
  (check-= ((make-controller 10) 2.0 1.0 1) 1.8 0.1)
  (check-= ((make-controller 10) 1.0 0.0 1) 8.0 1e-12))

;; The steps that are tried where the error of a step h after n accepted ones is c(n) h^4:
;; pairs of a length and an error
(define (tries c count)
  (define control (make-controller 10))
  (let loop ([h 1.0] [n 0])
    (define error (* (c n) h h h h))
    (if (= n count)
        '()
        (cons (cons h error)
              (loop (control h error 2) (if (<= error 1.0) (+ n 1) n))))))

(define (rejections steps) (for/sum ([s (in-list steps)]) (if (> (cdr s) 1.0) 1 0)))

(test-case "constant errors lead to constant steps"
  (define steps (tries (lambda (n) 1e-3) 20))
  (check-equal? (rejections steps) 0)
  (for ([s (in-list (list-tail steps 5))])
    (check-= (car s) (* 0.9 (expt 1e3 1/4)) 0.4)))

(test-case "errors that grow steadily are foreseen"
  (define steps (tries (lambda (n) (* 1e-3 (expt 2.0 n))) 40))
  (check-true (<= (rejections steps) 2) (format "~a" steps))    ; until two steps are known
  (for ([s (in-list (list-tail steps 8))])
    (check-= (cdr s) (expt (* 0.9 21/22) 4) 1e-6)))

(test-case "slow iterations make steps shorter"
  (check-true (< ((make-controller 10) 1.0 0.5 10) ((make-controller 10) 1.0 0.5 1))))

(test-case "after a rejected step the next one is not longer"
  (define control (make-controller 10))
  (control 1.0 3.0 2)
  (check-true (<= (control 0.5 1e-6 2) 0.5))
  (check-true (> (control 0.5 1e-6 2) 0.5)))
