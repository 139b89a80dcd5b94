#lang racket/base
;; Messages of integration on wrong questions.

(require mechanics
         (only-in mechanics/book L-harmonic)
         mechanics/error/progress mechanics/motion/progress-text
         "../support/checks.rkt" "../support/messages.rkt" "../support/notes.rkt")

(define (harmonic m k) (Lagrangian->state-derivative (L-harmonic m k)))
(define oscillator (harmonic 1 1))
(define start (up 0 1 0))
(define advance (state-advancer harmonic 1 1))
(define follow (evolve harmonic 1 1))
(define (until end #:tolerance [tolerance 1e-10] #:events [events '()]
               #:method [method 'Dormand-Prince-853])
  (evolve-trajectory oscillator start end #:tolerance tolerance #:events events #:method method))

;; ---------------------------------------------------------------------------
;; Arguments

(says
 [(advance start)
  "(state-advancer harmonic 1 1): takes a state, a duration and perhaps a tolerance\n"
  "  given: (up 0 1 0), an up tuple of 3"]
 [(advance)
  "(state-advancer harmonic 1 1): takes a state, a duration and perhaps a tolerance\n"
  "  given: no arguments"]
 [(advance start 1 1e-10 list 5)
  "(state-advancer harmonic 1 1): takes a state, a duration and perhaps a tolerance\n"
  "  given: 5 arguments"]
 [(follow start void)
  "(evolve harmonic 1 1): takes a state, a monitor, a time step, a final time and perhaps"
  " a tolerance\n  given: 2 arguments"]
 [(advance start 'T)
  "state-advancer: expected a duration that is a real number\n  given: the symbol T\n"
  "  give its symbols values first"]
 [(advance start +inf.0)
  "state-advancer: expected a duration that is finite\n  given: the number +inf.0"]
 [(advance start +nan.0)
  "state-advancer: expected a duration that is finite\n  given: the number +nan.0"]
 [(advance start 1 -1)
  "state-advancer: expected a positive tolerance\n  given: the number -1"]
 [(advance start 1 0)
  "state-advancer: expected a positive tolerance\n  given: the number 0"]
 [(advance start 1 +nan.0)
  "state-advancer: expected a tolerance that is finite\n  given: the number +nan.0"]
 [(advance start 1 +inf.0)
  "state-advancer: expected a tolerance that is finite\n  given: the number +inf.0"]
 [(advance start 1 1e-16)
  "state-advancer: the tolerance is below the rounding error of flonums, about 1e-15\n"
  "  given: the number 1e-16"]
 [(advance start 1 "1e-3")
  "state-advancer: expected a tolerance that is a real number\n  given: \"1e-3\", a string"]
 [(advance start 1 1e-10 #:longest-step 0)
  "state-advancer: expected a positive longest step\n  given: the number 0"]
 [(advance start 1 1e-10 #:most-steps 2.5)
  "state-advancer: expected the most steps to take, a positive integer\n  given: the number 2.5"]
 [(follow start void -0.1 1)
  "evolve: expected a positive time step\n  given: the number -0.1\n"
  "  the final time says whether to go forwards or back"]
 [(follow start void +nan.0 1)
  "evolve: expected a time step that is finite\n  given: the number +nan.0"]
 [(follow start void 0.1 +inf.0)
  "evolve: expected a final time that is finite\n  given: the number +inf.0"]
 [(follow start (lambda (t s) s) 0.1 1)
  "evolve: expected a monitor, a procedure of one state\n"
  "  given: a function without a name, which takes 2 arguments"]
 [(follow start 'print 0.1 1)
  "evolve: expected a monitor, a procedure of one state\n  given: the symbol print"]
 [(until 'T)
  "evolve-trajectory: expected a final time that is a real number\n  given: the symbol T\n"
  "  give its symbols values first"]
 [(until 1 #:tolerance -1e-9)
  "evolve-trajectory: expected a positive tolerance\n  given: the number -1e-9"])

;; ---------------------------------------------------------------------------
;; States, derivatives and parameters

(says
 [(advance (up 0 1 'v) 1)
  "state-advancer: expected a state of real numbers; the symbol v is none\n  state: (up 0 1 v)\n"
  "  give its symbols values first"]
 [(advance (up 0 1+i 0) 1)
  "state-advancer: expected a state of real numbers; the number 1+1i is none\n"
  "  state: (up 0 1+1i 0)"]
 [(advance (up 0 (up 1 2) (up 1 2 3)) 1)
  "Lagrangian->state-derivative: the velocities are of another shape than the coordinates\n"
  "  coordinates: (up 1.0 2.0)\n  velocities: (up 1.0 2.0 3.0)"]
 [((state-advancer harmonic 1 'k) start 1)
  "state-advancer: the symbol k is left in the state derivative\n"
  "  state derivative: (up 1 0.0 (* -1.0 k))\n"
  "  give it as a parameter, or substitute a number for it"]
 [(evolve-trajectory (lambda (s) (up 1 (velocity s) (* 'g (coordinate s)))) start 1)
  "evolve-trajectory: the symbol g is left in the state derivative\n"
  "  state derivative: (up 1 0.0 (* 1.0 g))\n"
  "  give it as a parameter, or substitute a number for it"]
 [((state-advancer L-harmonic 1 1) start 1)
  "state-advancer: the state derivative is of another shape than the state\n"
  "  state: (up 0 1 0)\n  derivative: -0.5\n"
  "  (Lagrangian->state-derivative L) makes a state derivative of a Lagrangian"]
 [((state-advancer (lambda (k) (lambda (s) (up 1 k))) 2) start 1)
  "state-advancer: the state derivative is of another shape than the state\n"
  "  state: (up 0 1 0)\n  derivative: (up 1 2)"]
 [(evolve-trajectory (lambda (s) (up 1 0 "fast")) start 1)
  "evolve-trajectory: the state derivative holds \"fast\", a string; expected real numbers\n"
  "  state derivative: (up 1 0 \"fast\")"]
 [((state-advancer (lambda (k) k) 2) start 1)
  "state-advancer: expected a state derivative, a function of the state\n  given: the number 2"])

(define (L-of-many (up t q v)) (* 1/2 (square v)))

(says
 [(evolve-trajectory (Lagrangian->state-derivative L-of-many)
                     (up 0 (up 1 2 3 4 5 6) (up 1 2 3 4 5 6 7)) 1)
  "Lagrangian->state-derivative: the velocities are of another shape than the coordinates\n"
  "  coordinates: (up 1.0 2.0 3.0 4.0 5.0 6.0)\n"
  "  velocities: (up 1.0 2.0 3.0 4.0 5.0 6.0 7.0)"])

(define ((spring k) s) (up 1 (velocity s) (* -1 k (coordinate s))))

(says
 [(evolve-trajectory spring start 1)
  "evolve-trajectory: the state derivative is of another shape than the state\n"
  "  state: (up 0 1 0)\n  derivative: spring\n"
  "  parameters are supplied first: (spring ...)"])

;; ---------------------------------------------------------------------------
;; Methods and events

(says
 [(until 1 #:method leapfrog)
  "evolve-trajectory: expected a method of integration or the name of one\n"
  "  given: the procedure `leapfrog`\n"
  "  a method with a fixed step is made of the step: (leapfrog 0.01)"]
 [(until 1 #:method 'euler)
  "evolve-trajectory: expected a method of integration or the name of one\n"
  "  given: the symbol euler\n"
  "  names: (auto Taylor Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5)"]
 [(until 1 #:method 'RK45)
  "evolve-trajectory: expected a method of integration or the name of one\n"
  "  given: the symbol RK45\n"
  "  take 'Dormand-Prince-54, or 'Dormand-Prince-853"]
 [(until 1 #:method "Verlet")
  "evolve-trajectory: expected a method of integration or the name of one\n"
  "  given: \"Verlet\", a string\n"
  "  take (leapfrog h), or (Yoshida-8 h), h being the step"]
 [(leapfrog -1) "leapfrog: expected a positive time step\n  given: the number -1"]
 [(event harmonic)
  "event: expected a function of one state\n"
  "  given: the procedure `harmonic`, which takes 2 arguments"]
 [(event 0) "event: expected a function of one state\n  given: the number 0"]
 [(until 1 #:events (event (lambda (s) (up (time s) 1)) #:name 'all))
  "evolve-trajectory: the value of an event's function is a real number\n"
  "  event: (event all)\n  value: (up 0.0 1), an up tuple of 2"]
 [(trajectory-states (until 1) 0.5)
  "trajectory-states: expected a list of times\n  given: the number 0.5"])

;; ---------------------------------------------------------------------------
;; Keywords that are those of another procedure

(define ((unknown who given known [advice ""]) e)
  (equal? (exn-message e)
          (format "~a: there is no keyword ~s here\n  its keywords: ~s~a" who given known advice)))

(define (after what)
  (format "\n  the tolerance is given without one, after the ~a" what))

(test-case "an unknown keyword names the procedure that was made, and those it takes"
  (define known '(#:longest-step #:method #:most-steps #:precision #:progress?))
  (check-exn (unknown 'state-advancer '#:tolerance known (after "duration"))
             (lambda () (advance start 1 #:tolerance 1e-9)))
  (check-exn (unknown 'evolve '#:tolerance known (after "final time"))
             (lambda () (follow start void 0.1 1 #:tolerance 1e-9))))

(test-case "what is loaded on demand tells how many arguments it takes"
  (check-message (string-append "find-path: takes 6 arguments; it was given 4\n"
                                "  its keywords: (#:most-steps #:observe #:progress? #:tolerance)")
                 (find-path values (up 0 1) (up 1 0) 3)
                 exn:fail:contract:arity?)
  (check-message (string-append "minimize: takes 3 arguments; it was given 2\n"
                                "  its keywords: (#:observe #:progress? #:tolerance)")
                 (minimize values 0 #:tolerance 1e-3)
                 exn:fail:contract:arity?)
  (check-message
   "event: takes 1 argument; it was given none\n  its keywords: (#:direction #:name #:terminal?)"
   (event)
   exn:fail:contract:arity?))

(test-case "what is loaded on demand tells its keywords"
  (check-exn (unknown 'event '#:directon '(#:direction #:name #:terminal?))
             (lambda () (event values #:directon 'rising)))
  (check-exn (unknown 'find-path '#:tol '(#:most-steps #:observe #:progress? #:tolerance))
             (lambda () (find-path values 0 0 1 1 1 #:tol 1)))
  (check-exn (unknown 'evolve-trajectory '#:event
                      '(#:events #:longest-step #:method #:most-steps #:precision #:progress?
                        #:tolerance))
             (lambda () (evolve-trajectory oscillator start 1 #:event '())))
  (check-exn (unknown 'cubic-spline '#:end '(#:ends #:extrapolate?))
             (lambda () (cubic-spline '(0 1) '(0 1) #:end 'natural))))

(test-case "how far a run is, to a thousandth of its end"
  (define (told t end) (progress-text 'evolve t end))
  (check-equal? (told 37.21 100.0) "evolve: t = 37.2 of 100.0")
  (check-equal? (told 0.1234 10.0) "evolve: t = 0.12 of 10.00")
  (check-equal? (told 12345.6 2e6) "evolve: t = 12345.6 of 2000000.0")
  (check-equal? (told -0.00123 -0.01) "evolve: t = -0.0012 of -0.0100"))

(test-case "a long run tells it to whoever waits"
  (define-values (port now) (values (open-output-string) 0))
  (define (clock) (set! now (+ now 1000)) now)
  (parameterize ([current-reporter (reporter port clock)]) (evolve-trajectory oscillator start 50))
  (check-regexp-match #px"\revolve-trajectory: t = \\d+[.]\\d\\d of 50[.]00\e"
                      (get-output-string port)))

;; x = π is left for 0 or 2π.
(test-case "of one number without the time it is noted, too, that rounding ends a rest"
  (define (away s) (up (- (sin (ref s 0)))))
  (define (noted end) (told (evolve-trajectory away (up pi) end)))
  (check-regexp-match #rx"the motion begins at rest but for rounding" (noted 60))
  (check-equal? (noted 5) ""))
