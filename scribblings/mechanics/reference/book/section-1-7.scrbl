#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-1-7"]{1.7 Evolution of dynamical state}

@(define session (make-session '(require mechanics/book mechanics/plot)))

@defproc[(harmonic-state-derivative [m scalar] [k scalar]) procedure?]{

The state derivative of @racket[L-harmonic], made from its parameters as
@racket[state-advancer] wants it.

@examples[#:eval session
((harmonic-state-derivative 'm 'k) (up 't (up 'x 'y) (up 'v_x 'v_y)))
((state-advancer harmonic-state-derivative 2 1)
 (up 1 (up 1 2) (up 3 4)) 10 1e-12)]

@sicm{pp. 72 and 74}}

@defproc[((periodic-drive [amplitude scalar] [frequency scalar] [phase scalar]) [t scalar])
         scalar]{

A cos(ωt + φ), the height of a pivot that is shaken.

@examples[#:eval session ((periodic-drive 'A 'omega 'phi) 't)]

@sicm{p. 74}}

@deftogether[(@defproc[(L-periodically-driven-pendulum [m scalar] [l scalar] [g scalar]
                                                       [A scalar] [omega scalar])
                       procedure?]
              @defproc[(pend-state-derivative [m scalar] [l scalar] [g scalar]
                                              [A scalar] [omega scalar])
                       procedure?])]{

A pendulum whose pivot is shaken up and down with the amplitude A, and its state
derivative.

@examples[#:eval session
((L-periodically-driven-pendulum 'm 'l 'g 'A 'omega) (up 't 'theta 'thetadot))
((pend-state-derivative 'm 'l 'g 'A 'omega) (up 't 'theta 'thetadot))
((state-advancer pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
 (up 0 1 0) 10 1e-13)]

@sicm{pp. 74 and 75}}

@defproc[((monitor-theta [win frame?]) [state value]) any]{

A monitor for @racket[evolve] that draws the angle of a pendulum against the time as a
point, brought back to between −π and π. @racketmodname[mechanics/plot] is loaded when the
first point is drawn.

@examples[#:eval session
(define plot-win (frame 0 100 :-pi :pi #:width 500 #:height 250))
(define last-state
  ((evolve pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
   (up 0 1 0) (monitor-theta plot-win) 0.01 100 1e-13))
plot-win]

@sicm{p. 76}}

@(close-session session)
