#lang racket/base
;; Messages of fit-motion on data and systems that it cannot fit.

(require mechanics
         (only-in mechanics/book L-pendulum)
         "../../support/checks.rkt" "../../support/messages.rkt")

(define (pendulum g m l) (Lagrangian->state-derivative (L-pendulum g m l)))
(define known (pendulum 9.8 1 1.2))
(define motion (evolve-trajectory known (up 0 1.0 0.3) 10))
(define (angle s) (ref s 1))
(define data (for/list ([k 30]) (let ([t (/ k 3.0)]) (list t (angle (motion t))))))
(define near (up 0 0.9 0.1))
(define (fit guesses [held '()] [data data] [measured angle] [deviation #f])
  (fit-motion pendulum near data #:parameters guesses #:hold held #:measured measured
              #:deviation deviation))
(define guesses '((g 9.8) (m 1) (l 1.1)))

(test-case "what the data do not determine is named"
  (check-message (string-append "fit-motion: the data do not determine all that is fitted\n"
                                "  without effect: m\n  only together: g, l\n"
                                "  #:hold tells those that are known")
                 (fit guesses) exn:fail:mechanics:singular?)
  (check-message (string-append "fit-motion: the data do not determine all that is fitted\n"
                                "  without effect: m\n  #:hold tells those that are known")
                 (fit guesses '(g)) exn:fail:mechanics:singular?))

(says
 [(fit guesses '() '((1 2) (2 3)))
  "fit-motion: 2 numbers were measured, and there are 5 unknowns\n"
  "  unknowns: q, v, g, m, l\n  #:hold tells those that are known"]
 [(fit guesses '() '((1 2) (2 +nan.0)))
  "fit-motion: the data are not all finite numbers\n  row: 1\n  column: 1\n  given: +nan.0"]
 [(fit guesses '() '((1 2) (2 -inf.0)))
  "fit-motion: the data are not all finite numbers\n  row: 1\n  column: 1\n  given: -inf.0"]
 [(fit guesses '() '((1 2) (2 x)))
  "fit-motion: expected real numbers as data\n  row: 1\n  given: the symbol x"]
 [(fit guesses '() '((1 2) (2 3 4)))
  "fit-motion: row 1 of the data has 2 numbers beside the time, the first one 1"]
 [(fit guesses '() '((-1 2)))
  "fit-motion: data before the time of the start\n  row: 0\n  time: -1.0\n  start: 0.0"]
 [(fit-motion pendulum (up 2 0.9 0.1) '((1 2)) #:parameters guesses #:measured angle)
  "fit-motion: data before the time of the start\n  row: 0\n  time: 1.0\n  start: 2.0"]
 [(fit guesses '() '((1)))
  "fit-motion: expected a time and what was measured then\n  row: 0\n  given: (1)"]
 [(fit guesses '() 3)
  "fit-motion: expected a table, or a list of rows (up t x ...), of measured data\n"
  "  given: the number 3"]
 [(fit guesses '(len)) "fit-motion: there is no unknown len to hold\n  there are: t, q, v, g, m, l"]
 [(fit guesses '(q v g m l)) "fit-motion: nothing is left to fit: all is held"]
 [(fit '(9.8 1 1.1))
  "fit-motion: expected #:parameters with names and first values, as '((g 9.8) (l 1))\n"
  "  given: (9.8 1 1.1), a list"]
 [(fit '((g 9.8) (q 1) (l 1)))
  "fit-motion: a parameter has the name of a variable of the state\n  name: q"]
 [(fit '((g 9.8)))
  "fit-motion: expected as many parameters as the maker of the state derivative takes\n"
  "  maker: the procedure `pendulum`, which takes 3 arguments\n  parameters: (9.8)"]
 [(fit guesses '() data #f)
  "fit-motion: each row has 1 number beside the time, and the state has 2\n"
  "  #:measured is the function of the state that was measured"]
 [(fit guesses '() data angle -1)
  "fit-motion: expected a positive standard deviation, or a list of 1, one for each column\n"
  "  given: the number -1"]
 [(fit guesses '() data 3)
  "fit-motion: expected #:measured, a function of the state\n  given: the number 3"]
 [(motion-fit-values 3)
  "motion-fit-values: expected a fit, as fit-motion gives it\n  given: the number 3"])
