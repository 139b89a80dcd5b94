#lang racket/base
;; Motions asked for with something left out or of another kind: a monitor without its
;; frame was called for nothing, and messages spoke of "the value" without saying whose, of
;; an infinite time as no real number, or of a place in the library.

(require mechanics
         (only-in mechanics/book L-pendulum)
         "../support/checks.rkt" "../support/messages.rkt")

(define (pendulum m) (Lagrangian->state-derivative (L-pendulum 9.8 m 1)))
(define swing (pendulum 1))
(define start (up 0 1 0))
(define (until-1 #:events [events '()] #:precision [bits #f])
  (evolve-trajectory swing start 1 #:events events #:precision bits))

(test-case "a monitor that returns a function lacks arguments"
  (define seen '())
  (define ((monitor-into place) state) (set! seen (cons (time state) seen)))
  (for ([bits '(#f 80)])
    (check-message
     (string-append "evolve: the monitor returns a function; it does nothing with the state\n"
                    "  monitor: the procedure `monitor-into`\n"
                    "  parameters are supplied first: (monitor-into ...)")
     ((evolve swing) start monitor-into 0.5 1 #:precision bits)))
  ((evolve swing) start (monitor-into 'here) 0.5 1)
  (check-equal? seen '(1.0 0.5 0.0)))

(test-case "what else a monitor returns is nobody's business"
  (define end ((evolve swing) start void 0.5 1))
  (for ([monitor (list values
                       (lambda (s) (values 1 2))
                       (lambda (s) (values))
                       (lambda (s) #f)
                       coordinate)])
    (check-equal? ((evolve swing) start monitor 0.5 1) end)))

(test-case "an event's function that gives no number is named"
  (define who "evolve-trajectory: the value of an event's function is a real number\n")
  (define (above s) (> (coordinate s) 0))
  (define (symbolic s) (* 'a (coordinate s)))
  (define (everything s) s)
  (for ([bits '(#f 80)])
    (check-message (string-append who
                                  "  event: (event above)\n  value: #t, a boolean\n"
                                  "  it passes through zero: (- a b) where (< a b) changes")
                   (until-1 #:events (event above) #:precision bits)))
  (check-message
   (string-append who
                  "  event: (event symbolic)\n  value: (* 1.0 a), a number-like expression\n"
                  "  give its symbols values first")
   (until-1 #:events (event symbolic)))
  (check-message
   (string-append who
                  "  event: (event everything)\n  value: (up 0.0 1.0 0.0), an up tuple of 3")
   (until-1 #:events (event everything))))

(test-case "an event's function that has no value at the start is one that happens later"
  (define (inverse s) (- (/ 1 (time s)) 2))
  (define found (trajectory-events (until-1 #:events (event inverse))))
  (check-= (occurrence-time (car found)) 1/2 1e-9))

(test-case "times are finite"
  (for ([t '(+inf.0 -inf.0 +nan.0)])
    (check-message (string-append "evolve-trajectory: expected a final time that is finite\n"
                                  "  given: the number "
                                  (number->string t))
                   (evolve-trajectory swing start t))))

(test-case "a maker of state derivatives, or a list, in place of one"
  (define shape "evolve-trajectory: the state derivative is of another shape than the state\n")
  (check-message
   (string-append shape
                  "  state: (up 0 1 0)\n  derivative: (Lagrangian->state-derivative L-pendulum)\n"
                  "  parameters are supplied first: (pendulum ...)")
   (evolve-trajectory pendulum start 1))
  (check-message (string-append shape
                                "  state: (up 0 1 0)\n  derivative: (1 0.0 0)\n"
                                "  a list is not a tuple; use (up x y ...)")
                 (evolve-trajectory (lambda (s) (list 1 (velocity s) 0)) start 1)))

(test-case "lists for coordinates"
  (check-message
   (string-append "find-path: expected a coordinate at the initial time that is a real number\n"
                  "  given: (0 0), a list\n  a list is not a tuple; use (up x y ...)")
   (find-path (L-pendulum 1 1 1) 0 '(0 0) 1 '(1 2) 2))
  (check-message
   (string-append "normal-modes: expected coordinates, a scalar or an up tuple of scalars\n"
                  "  given: (0 0), a list\n  a list is not a tuple; use (up x y ...)")
   (normal-modes (L-pendulum 1 1 1) '(0 0))))

(test-case "a trajectory is not differentiated; its rate of change is what was integrated"
  (define tr (until-1))
  (check-message
   (string-append
    "trajectory: a trajectory is not differentiated; its rate of change at a time is"
    " the state derivative of the state there: (compose state-derivative trajectory)\n"
    "  trajectory: (trajectory from 0.0 to 1.0)")
   ((D tr) 1))
  (check-= (velocity ((compose swing tr) 0.5)) (* -9.8 (sin (coordinate (tr 0.5)))) 1e-9))

(test-case "Dt takes one function"
  (check-message "Dt: takes one function; it was given no argument"
                 (Dt))
  (check-message "Dt: takes one function; it was given 2 arguments"
                 (Dt coordinate (up 't 'x 'v))))
