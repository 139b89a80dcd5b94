#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../../eval.rkt"
          "../../citation.rkt")

@title[#:tag "reference-book-2-8"]{2.8 Motion of a free rigid body}

@(define session
   (make-session '(require mechanics/book mechanics/plot)))

@defproc[(relative-error [value scalar] [reference-value scalar]) scalar]{

How far a value is from another one, as a part of that, which must not be 0.

@examples[#:eval session
(relative-error 1.001 1)
(eval:error (relative-error 1 0))]

@sicm{p. 145}}

@defproc[((monitor-errors [win frame?] [A scalar] [B scalar] [C scalar] [L0 tuple] [E0 scalar])
          [state local-tuple])
         void?]{

A monitor for @racket[evolve] that draws the relative errors of the angular momentum in space
and of the energy, which were L0 and E0 at the start. That they are conserved
@racket[verify-conserved] proves; here one sees what the integration makes of it.

@examples[#:eval session
(define errors (frame 0 100 -1e-12 1e-12 #:width 500 #:height 250))
(define start (up 0 (up 1 0 0) (up 0.1 0.1 0.1)))
(define last-state
  ((evolve rigid-sysder 1 (sqrt 2) 2)
   start
   (monitor-errors errors 1 (sqrt 2) 2
                   ((L-space-Euler 1 (sqrt 2) 2) start)
                   ((T-body-Euler 1 (sqrt 2) 2) start))
   0.1 100 1e-13))
errors]

@sicm{p. 145}}

@(close-session session)
