#lang racket/base
;; Programs that gave a number without a word, and not the right one: leapfrog with friction, a
;; value at one point of a function that Racket's tests decide, a parameter that had become
;; a flonum, events without a value and poles taken for zeros.

(require (only-in racket/base [= racket:=] [case racket:case])
         racket/flonum
         mechanics
         "../support/checks.rkt")

(define start (up 0 1 0))
(define (oscillator s) (up 1 (velocity s) (- (coordinate s))))

(test-case "leapfrog took friction for half of what it was"
  (define (damped s) (up 1 (velocity s) (- (* -1 (coordinate s)) (* 0.1 (velocity s)))))
  (check-exn #rx"^state-advancer: leapfrog .*the rates of the velocities depend on the velocities"
             (lambda ()
               ((state-advancer (lambda () damped)) start 1 1e-10 #:method (leapfrog 0.1)))))

(test-case "the value of sin(x)/x at 0, by tests that no trace sees"
  (for ([f (list (lambda (x) (if (eqv? x 0.0) 1 (/ (sin x) x)))
                 (lambda (x) (if (and (real? x) (racket:= x 0)) 1 (/ (sin x) x)))
                 (lambda (x) (match x [0.0 1] [_ (/ (sin x) x)])))])
    (define c (compile-function f 0.0))
    (check-equal? (c (flvector 0.0)) (flvector 1.0))
    (check-equal? (c (flvector 2.0)) (flvector (/ (sin 2.0) 2.0)))))

(test-case "a root on one side of zero, and none on the other"
  (define (f x) (if (and (real? x) (< x 0)) 0 (sqrt x)))
  (define c (compile-function f 4.0))
  (check-equal? (c (flvector -1.0)) (flvector 0.0))
  (check-equal? (c (flvector 9.0)) (flvector 3.0)))

(test-case "an exact parameter was a flonum where it chose"
  (define ((pushed mode) s) (up 1 (velocity s) (racket:case mode [(1) 6] [else 0])))
  (check-= (velocity ((state-advancer pushed 1) (up 0 0 0) 1)) 6 1e-12)
  (check-= (velocity ((state-advancer pushed 2) (up 0 0 0) 1)) 0 1e-12))

(test-case "an event without a real value never happened"
  (check-exn #rx"the function of an event has no real value"
             (lambda ()
               (evolve-trajectory oscillator start 1
                                  #:events (event (lambda (s) (log (- 0.5 (time s)))))))))

(test-case "a pole was an event"
  (define f (event (lambda (s) (/ 1 (- (time s) 0.513)))))
  (check-equal? (trajectory-events (evolve-trajectory oscillator start 1 #:events f)) '()))
