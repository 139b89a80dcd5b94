#lang racket/base
;; Single steps, and what an advancer passes on.

(require mechanics "../support/checks.rkt" "../support/messages.rkt")

(define ((growth a) s) (up 1 (* a (ref s 1))))
(define ((spread a) s) (up 1 (up (* a (ref s 1 0)) (/ (ref s 1 1) a))))

(test-case "a step goes no further than it is told to, and in that direction"
  (for ([step '(1 1/100 -1/100 -1)])
    (define-values (s taken next) ((free-run-state-advancer spread 2) (up -1 (up 1 1)) step 1e-12))
    (check-true (<= 0 (/ taken step) 1))
    (check-true (positive? (/ next step)))
    (check-= (time s) (+ -1 taken) 1e-15)
    (check-= (ref s 1 0) (exp (* 2 taken)) 1e-12)
    (check-= (ref s 1 1) (exp (/ taken 2)) 1e-12))
  (define-values (s taken next) ((free-run-state-advancer spread 2) (up -1 (up 1 1)) 1/100 1e-12))
  (check-= taken 0.01 1e-15)
  (check-true (> next 0.01)))

;; x = 1/(6 - t)
(test-case "where the motion ends before, the step is as much shorter as is told"
  (define ((ending) s) (up 1 (square (ref s 1))))
  (define-values (s taken next) ((free-run-state-advancer ending) (up 5 1) 2 1e-10))
  (check-true (< 0 taken 1))
  (check-= (time s) (+ 5 taken) 1e-15)
  (check-= (ref s 1) (/ 1 (- 1 taken)) 1e-8))

(test-case "what continues is told the state, the step and the next step, and decides the result"
  (define result ((free-run-state-advancer growth 2) (up 0 1) 1/8 1e-10 list))
  (check-equal? (length result) 3)
  (check-equal? (cadr result) 0.125))

(test-case "a step of nothing changes nothing"
  (check-equal? ((free-run-state-advancer growth 2) (up 3 1) 0 1e-10 list)
                (list (up 3.0 1.0) 0.0 0.0)))

(test-case "steps made one by one end where the advancer ends"
  (define advance (free-run-state-advancer growth 2))
  (define last
    (let loop ([s (up 0 1)] [step 1])
      (define rest (- 1 (time s)))
      (if (< rest 1e-14)
          s
          (advance s (min step rest) 1e-12 (lambda (s taken next) (loop s next))))))
  (check-= (ref last 1) (exp 2.0) 1e-10))

(test-case "an advancer of a state derivative, with its dimension or without"
  (define (f s) (up 1 (ref s 1)))
  (define-values (s taken next) ((ode-advancer f 1e-12 2) (up 0 1) 1))
  (check-= (ref s 1) (exp (time s)) 1e-12)
  (check-equal? ((ode-advancer f 1e-12) (up 0 1) 1 list) (list s taken next))
  (check-exn #rx"^ode-advancer: the state is not of the dimension declared"
             (lambda () ((ode-advancer f 1e-12 3) (up 0 1) 1)))
  (check-exn #rx"^ode-advancer: " (lambda () (ode-advancer 3 1e-12))))

(test-case "advancing beyond a time, forwards and backwards"
  (for ([step '(1/10 -1/10)] [target '(3 -3)])
    (define-values (s taken next) ((advance-beyond growth 2) (up 0 1) step 1e-10 target))
    (check-true (>= (* step (time s)) (* step target)))
    (check-true (< (* step (- (time s) taken)) (* step target)))
    (check-= (/ (ref s 1) (exp (* 2 (time s)))) 1 1e-9))
  (check-equal? ((advance-beyond growth 2) (up 5 1) 1/10 1e-10 3 list) (list (up 5 1) 0 1/10))
  (check-exn #rx"^advance-beyond: the first component of the state is not the time"
             (lambda () ((advance-beyond (lambda () (lambda (s) (* 2 s)))) (up 0 1) 1/10 1e-10 3))))

(test-case "a state advancer continues with the state, the duration and a step"
  (define-values (s duration next) ((state-advancer growth 2) (up 0 1) 3 1e-12 values))
  (check-equal? s ((state-advancer growth 2) (up 0 1) 3 1e-12))
  (check-equal? duration 3)
  (check-true (< 0 next 3))
  (check-true (negative? (caddr ((state-advancer growth 2) (up 0 1) -3 1e-12 list)))))

(test-case "a method with steps of its own takes one of them"
  (define-values (s taken next)
    ((free-run-state-advancer growth 2) (up 0 1) 1 1e-10 #:method (Gauss-Legendre-2 1/4)))
  ;; the implicit midpoint rule: (1 + 1/4)/(1 - 1/4)
  (check-= (ref s 1) 5/3 1e-12)
  (check-equal? (list (time s) taken next) '(0.25 0.25 0.25)))

(test-case "where no step is short enough the last state is told"
  (define ((wall) s) (up 1 (/ 1 (- 1 (time s)))))
  (check-exn #rx"^free-run-state-advancer: the motion cannot be followed any further"
             (lambda () ((free-run-state-advancer wall) (up 1 0) 1 1e-10)))
  (check-exn #rx"^free-run-state-advancer: expected a step that is a real number\n  given: "
             (lambda () ((free-run-state-advancer growth 2) (up 0 1) 'h 1e-10))))

(test-case "what they take is told"
  (check-message (string-append "(free-run-state-advancer growth 2): takes a state, a step and "
                                "perhaps a tolerance\n  given: no arguments")
                 ((free-run-state-advancer growth 2)))
  (check-message (string-append "(advance-beyond growth 2): takes a state, a step, a tolerance and "
                                "a time\n  given: 3 arguments")
                 ((advance-beyond growth 2) (up 0 1) 1/10 3)))

(test-case "they print as what was typed"
  (check-equal? (format "~a ~a ~a" (free-run-state-advancer growth 2) (advance-beyond growth 2)
                        (ode-advancer (growth 2) 1e-10))
                "(free-run-state-advancer growth 2) (advance-beyond growth 2) (ode-advancer growth 1e-10)"))
