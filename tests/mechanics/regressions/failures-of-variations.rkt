#lang racket/base
;; Exponents and linearized flows follow a state with its displacements, and tell the state alone
;; where that motion ends.  They told whatever had no value so, the user's failures with it: a root
;; without a derivative was "the motion cannot be followed any further, last state: 0.0".

(require (except-in mechanics time)
         "../support/checks.rkt" "../support/messages.rkt")

(define (root s) (up 1 (sqrt (ref s 1)) (ref s 1)))
(define at-0 (up 0 0.0 1.0))

(define asked
  (list (lambda (f at) (Lyapunov-exponents f at 2 #:interval 0.5))
        (lambda (f at) (maximal-Lyapunov-exponent f at 2 #:interval 0.5))
        (lambda (f at) ((linearized-flow (lambda () f)) at 2))
        (lambda (f at) (Floquet-multipliers f at 2))))

(test-case "what has no value at the start comes through as it was raised"
  (for ([ask asked])
    (define (raised? e) (and (exn:fail:mechanics:singular? e)
                             (eqv? 0.0 (exn:fail:mechanics:singular-where e))))
    (check-message "sqrt: has no derivative at 0.0" (ask root at-0) raised?)))

(define (raise-own) (raise (exn:fail:mechanics:singular "wall: no force beyond 1"
                                                        (current-continuation-marks)
                                                        (up 'a 'b))))
(define (wall s) (if (>= (ref s 1) 1) (raise-own) (up 1 (ref s 2) 0)))

(test-case "what it says further on is told with the last state"
  (for ([ask asked])
    (define message (message-of (ask wall (up 0 0.25 1.0)) exn:fail:mechanics:singular?))
    (check-regexp-match (string-append
                         "^[A-Za-z-]+: the motion cannot be followed any further\n"
                         "  last state: [(]up 0?[.]7[0-9.]* [^()]* [^()]*[)]\n"
                         "  (there|beyond): wall: no force beyond 1$")
                        message)))

(test-case "it begins where an interval does"
  (check-message "wall: no force beyond 1" (Lyapunov-exponents wall (up 0 1.0 1.0) 2)
                 exn:fail:mechanics:singular?))
