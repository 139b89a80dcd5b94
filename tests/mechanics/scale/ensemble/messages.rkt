#lang racket/base
;; Messages of evolve-ensemble on systems it cannot follow.

(require mechanics/book
         mechanics
         (only-in mechanics/motion/observed-systems call-watching-systems)
         tests/mechanics/support/messages
         "../../support/checks.rkt")

(define (pendulum m l g) (Lagrangian->state-derivative (L-pendulum g m l)))
(define (plane s) (up 1 (ref s 1)))
(define bottom (event (lambda (s) (ref s 1)) #:name 'bottom #:direction 'falling))

(test-case "a Lagrangian is no state derivative"
  (check-exn #rx"another shape than the state.*[(]Lagrangian->state-derivative L[)] makes"
             (lambda () (evolve-ensemble (L-pendulum 9.8 1 1) (list (up 0 1 0)) 1))))

(define free (pendulum 1 1 9.8))
(define (cannot-add v) (message-of (+ v 0)))
(define one-crossing (car (evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:jobs 1)))
(define lost (car (evolve-ensemble pendulum (list (up 0 1 0)) 1 #:parameters '((1 0 9.8)))))

(says
 [(sweep '((g 9.8) (length 1)) 'lenght '(1 2))
  "sweep: there is no parameter lenght; did you mean length?\n  there are: g, length"]
 [(sweep '(g 9.8) 'g '(1))
  "sweep: expected the parameters with their values, such as '((m 1) (l 2))\n"
  "  given: (g 9.8), a list"]
 [(sweep '((g 9.8)) 'g 3)
  "sweep: expected the values that it takes, a list or another sequence\n"
  "  given: the number 3"])

(says
 [(evolve-ensemble free '() 1) "evolve-ensemble: there are no starts"]
 [(evolve-ensemble free (up 0 1 0) 1)
  "evolve-ensemble: expected the starts as a list or another sequence of states\n"
  "  given: (up 0 1 0), an up tuple of 3"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 1)) 1)
  "evolve-ensemble: start 1 has 2 numbers, the first one 3\n  start: (up 0 1)"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 +nan.0 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (up 0 +nan.0 0)"]
 [(evolve-ensemble free (list (up 0 1 0) (up 0 'x 0)) 1)
  "evolve-ensemble: start 1 is not made of finite real numbers\n  start: (up 0 x 0)"]
 [(evolve-ensemble pendulum (list (up 0 1 0) (up 0 1 0)) 1 #:parameters '((1 1 9.8)))
  "evolve-ensemble: there are more starts than rows of parameters\n  from: 1"]
 [(evolve-ensemble pendulum (list (up 0 1 0)) 1 #:parameters '(1 1 9.8))
  "evolve-ensemble: the parameters of a start are a list of finite numbers and tuples of"
  " them\n  of start 0: 1"]
 [(evolve-ensemble (lambda (s) (up 1 (ref s 2) (ref s 1) 7)) (list (up 0 1.0 0.0)) 2)
  "evolve-ensemble: the state derivative is of another shape than the state\n"
  "  state: (up 0 1.0 0.0)\n  derivative: (up 1 0.0 1.0 7)"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:checkpoint "/no/such/folder/a")
  "evolve-ensemble: there is no such folder for the checkpoint\n  folder: /no/such/folder/"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:jobs 0)
  "evolve-ensemble: #:jobs is a positive integer\n  given: 0"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:method (leapfrog 0.1))
  "evolve-ensemble: methods are told to other processes by name\n  given: (leapfrog 0.1)"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:collect 3)
  "evolve-ensemble: #:collect is a procedure of a state\n  given: the number 3"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events 3)
  "evolve-ensemble: expected events; (event f) makes one of a function of the state\n"
  "  given: the number 3"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events (event (lambda (s) #t) #:name 'yes))
  "evolve-ensemble: the value of an event's function is a real number\n  event: (event yes)\n"
  "  value: #t, a boolean\n  it passes through zero: (- a b) where (< a b) changes"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:collect (lambda (s) s))
  "evolve-ensemble: #:collect is a procedure of a state and a list of occurrences, with #:events\n"
  "  given: a function without a name"]
 [(evolve-ensemble (list (up 0 1 0)) free 1)
  "evolve-ensemble: the state derivative comes first, then the starts\n"
  "  given first: ((up 0 1 0)), a list"]
 [(evolve-ensemble free 1 (list (up 0 1 0)))
  "evolve-ensemble: the starts come before the time where they end\n"
  "  given second: the number 1"]
 [(evolve-ensemble free 12 1)
  "evolve-ensemble: expected the starts as a list or another sequence of states\n"
  "  given: the number 12"]
 [(evolve-ensemble free (hash 'a (up 0 1 0)) 1)
  "evolve-ensemble: expected the starts as a list or another sequence of states\n"
  "  given: #hash((a . (up 0 1 0)))"]
 [(evolve-ensemble pendulum (list (up 0 1 0)) 1 #:parameters 3)
  "evolve-ensemble: expected the parameters as a sequence of lists, one for each start\n"
  "  given: the number 3"]
 [(evolve-ensemble plane (list (up 0 (up 1 2)) (up 0 1 2)) 1)
  "evolve-ensemble: start 1 is of another shape than the first one\n  start: (up 0 1 2)\n"
  "  first: (up 0 (up 1 2))"]
 [(evolve-ensemble pendulum (list (up 0 1 0) (up 0 1 0)) 1 #:parameters '((1 1 9.8) (1 +nan.0 9.8)))
  "evolve-ensemble: the parameters of a start are a list of finite numbers and tuples of them\n"
  "  of start 1: (1 +nan.0 9.8)"]
 [(evolve-ensemble pendulum (list (up 0 1 0) (up 0 1 0)) 1 #:parameters '((1 1 9.8) (1 1)))
  "evolve-ensemble: start 1 has parameters of another shape than the first one\n"
  "  parameters: (1 1)\n  of the first: (1.0 1.0 9.8)"]
 [(evolve-ensemble free (list (up 0 1 0)) 'later)
  "evolve-ensemble: expected a final time that is a real number\n  given: the symbol later\n"
  "  give its symbols values first"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:batch -1)
  "evolve-ensemble: #:batch is a positive integer\n  given: -1"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:fold +)
  "evolve-ensemble: #:fold comes with #:initial, what it is given with the first value\n"
  "  a sum: #:fold + #:initial 0\n  a list, the last value first: #:fold cons #:initial '()"]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:fold + #:initial 0 #:jobs 1)
  (string-append (cannot-add one-crossing)
                 "\n  #:fold was given the list of what happened on a motion, its value with "
                 "#:events\n  #:collect makes another value of it: "
                 "#:collect (lambda (state occurrences) (length occurrences))")]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:fold + #:initial 0 #:jobs 1
                   #:collect (lambda (state all) '()))
  (string-append (cannot-add '())
                 "\n  #:fold was given a list, what #:collect made of a motion")]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:events bottom #:fold + #:initial 0 #:jobs 1
                   #:collect (lambda (state all) (cons 'all all)))
  (string-append (cannot-add (cons 'all one-crossing))
                 "\n  #:fold was given a list, what #:collect made of a motion")]
 [(evolve-ensemble pendulum (list (up 0 1 0)) 1 #:parameters '((1 0 9.8)) #:fold + #:initial 0)
  (string-append (cannot-add lost) "\n  #:fold was given a motion that failed, "
                 (format "~s" lost) "\n  ensemble-failure? tells these")]
 [(evolve-ensemble free (list (up 0 1 0)) 1 #:initial 0)
  "evolve-ensemble: #:initial comes with #:fold, which is given it with the first value\n"
  "  given: #:initial 0\n  a sum: #:fold + #:initial 0"]
 [(ensemble-failure-index 3)
  "ensemble-failure-index: expected a failure, as evolve-ensemble gives it for a start\n"
  "  given: the number 3"])

(test-case "a parameter that is nothing makes motions fail, the first as any other"
  (for ([l '(0 0.0)])
    (define all
      (evolve-ensemble pendulum (list (up 0 1 0) (up 0 1 0)) 1 #:jobs 1
                       #:parameters (list (list 1 l 9.8) (list 1 l 9.8))))
    (check-true (andmap ensemble-failure? all))))

(test-case "crossings are counted, and where they are; no crossings are no failure"
  (define (crossings ends)
    (evolve-ensemble free (list (up 0 1 0) (up 0 2 0)) ends #:events bottom #:jobs 1
                     #:collect (lambda (state all) (length all)) #:fold + #:initial 0))
  (check-equal? (crossings 1) 2)
  (check-equal? (crossings 0.1) 0)
  (define there (occurrence-state (car one-crossing)))
  (check-= (ref there 0) (occurrence-time (car one-crossing)) 1e-12)
  (check-= (ref there 1) 0 1e-9))

(test-case "a thousand jobs are as many as are of use"
  (check-equal? (evolve-ensemble free (list (up 0 1 0) (up 0 2 0)) 1 #:jobs 1000 #:batch 1)
                (evolve-ensemble free (list (up 0 1 0) (up 0 2 0)) 1 #:jobs 1)))

(test-case "whoever watches what is followed learns of the system, once"
  (define seen '())
  (call-watching-systems
   (lambda followed (set! seen (cons followed seen)))
   (lambda () (evolve-ensemble pendulum (list (up 0 1 0) (up 0 2 0)) 1 #:jobs 1
                               #:parameters '((1 2 9.8) (1 3 9.8)))))
  (check-equal? seen (list (list pendulum '(1.0 2.0 9.8) (up 0 1 0)))))

(test-case "a sweep has a row for each value of one parameter"
  (check-equal? (sweep '((g 9.8) (length 1)) 'length (in-range 2 4)) '((9.8 2) (9.8 3))))

(test-case "states without the time begin at 0"
  (define (circle s) (up (ref s 1) (- (ref s 0))))
  (define end (car (evolve-ensemble circle (list (up 0.5 0.0)) 2 #:jobs 1)))
  (check-= (ref end 0) (* 0.5 (cos 2)) 1e-8)
  (check-= (ref end 1) (* -0.5 (sin 2)) 1e-8))

(test-case "a system that takes decisions, and so has no code, has its parameters"
  (define ((away speed) s) (up 1 (if (> (ref s 1) 0) speed (- speed))))
  (define ends
    (evolve-ensemble away (list (up 0 1) (up 0 -1)) 2 #:jobs 1 #:parameters '((3) (1/2))))
  (for ([end ends] [expected '(7 -2)]) (check-= (ref end 1) expected 1e-12)))

(test-case "a system that takes decisions is followed by the method and to the tolerance asked"
  (define (circle s) (if (> (ref s 1) -2) (up 1 (ref s 2) (- (ref s 1))) s))
  (define start (up 0.0 1.0 0.0))
  (for ([method '(Dormand-Prince-54 Dormand-Prince-853)] [tolerance '(1e-4 1e-10)])
    (check-equal? (evolve-ensemble circle (list start) 5 #:jobs 1 #:method method
                                   #:tolerance tolerance)
                  (list (trajectory-final-state
                         (evolve-trajectory circle start 5 #:method method
                                            #:tolerance tolerance))))))

;; x reaches 1 at the time 1/2.
(test-case "where it fails that is told, without a state"
  (define (to-pole s) (up 1 (if (> (ref s 1) 5) 0 (/ 1 (- 1 (ref s 1))))))
  (define failure (car (evolve-ensemble to-pole (list (up 0 0.0)) 2 #:jobs 1)))
  (check-equal? (ensemble-failure-index failure) 0)
  (check-false (ensemble-failure-state failure)))
