#lang racket/base
;; An event just where a step ended was missed, when the state interpolated there
;; and the one the next step began with lay on either side of it.

(require mechanics "../support/checks.rkt")

(define (oscillator s) (up 1 (velocity s) (- (coordinate s))))
(define (follow method . events)
  (evolve-trajectory oscillator (up 0 1 0) 3 #:method method #:events events))

(define (times-not-met method)
  (for/list ([t (cdr (map time (trajectory-states (follow method))))]
             #:unless (= 1 (length (trajectory-events
                                    (follow method (event (lambda (s) (- (time s) t))))))))
    t))

(for ([method (list 'Dormand-Prince-853 'Dormand-Prince-54 'bulirsch-stoer 'qcrk4
                    (leapfrog 0.1) (Gauss-Legendre-4 0.1))])
  (test-case (format "an event at the end of any step is met once by ~a" method)
    (check-equal? (times-not-met method) '())))

(test-case "the time of an event lies on the trajectory"
  (define tr (follow 'qcrk4 (event (lambda (s) (- (time s) 3)))))
  (for ([o (trajectory-events tr)])
    (check-true (<= (occurrence-time o) (trajectory-end tr)))))
