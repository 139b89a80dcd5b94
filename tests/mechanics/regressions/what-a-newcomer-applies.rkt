#lang racket/base
;; Slips that were accepted, or misled, when a newcomer made them: a selector given its tuple at
;; once, a tuple of coordinates for a transformation, Lagrange's equations for the rates of a
;; state, the logarithm of 0.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt" "../support/messages.rkt")

(define no-rates
  (string-append ": Lagrange-equations gives residuals of a path, not the rates of a state\n"
                 "  (Lagrangian->state-derivative L) makes a state derivative of a Lagrangian"))

(define ((residuals m k) q) ((Lagrange-equations (L-harmonic m k)) q))
(define (made m k) (Lagrange-equations (L-harmonic m k)))
(define start (up 0 1 2))

(says
 [(component 2 (up 1 2))
  "component: an index is an integer; given (up 1 2), an up tuple of 2\n"
  "  a selector is applied to a tuple: ((component 2) s)"]
 [(component 'x) "component: an index is an integer; given the symbol x"]
 [(F->C (up 'r 'phi))
  "F->C: a coordinate transformation is a function of the local tuple; "
  "given (up r phi), an up tuple of 2\n"
  "  its value is such a tuple: (lambda (local) (up ...))"]
 [(F->C (up sin 'r))
  "F->C: a coordinate transformation is a function of the local tuple; "
  "given (up sin r), an up tuple of 2\n"
  "  its value is such a tuple: (lambda (local) (up ...))"]
 [(evolve Lagrange-equations start 0.1 1.0) "evolve" no-rates]
 [((evolve Lagrange-equations) start void 0.1 1.0) "evolve" no-rates]
 [((evolve (made 1 1)) start void 0.1 1.0) "evolve" no-rates]
 [((evolve made 1 1) start void 0.1 1.0) "evolve" no-rates]
 [(evolve-trajectory (made 1 1) start 1) "evolve-trajectory" no-rates])

(test-case "what else is not of a state is told by what it makes of one"
  (check-regexp-match #rx"^Lagrange-equations: a path is a function of time"
                      (message-of ((evolve residuals 1 1) start void 0.1 1.0))))

(test-case "the logarithm of zero"
  (for ([f (list (lambda () (log 0)) (lambda () (log 0 2)) (lambda () (log 2 0)))])
    (check-message "log: the logarithm of 0 has no value" (f) exn:fail:contract:divide-by-zero?))
  (check-equal? (log 0.0) -inf.0)
  (check-equal? (log 1) 0))

(test-case "selectors, and tuples of functions as transformations, are as they were"
  (check-equal? ((component 1) (up 1 2)) 2)
  (check-equal? ((component 1 0) (up 1 (up 'a))) 'a)
  (check-equal? ((F->C (up coordinate)) (up 't 'x 'v)) (up 't (up 'x) (up 'v))))
