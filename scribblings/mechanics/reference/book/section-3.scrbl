#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-3"]{3.1 to 3.5 Hamiltonian mechanics}

@(define session (make-session '(require mechanics/book mechanics/plot)))

@deftogether[(@defproc[((H-rectangular [m scalar] [V procedure?]) [state structure?]) scalar]
              @defproc[((L-rectangular [m scalar] [V procedure?]) [local local-tuple]) scalar])]{

A particle in the plane with the potential energy V(x, y), as a Hamiltonian and as a Lagrangian.

@examples[#:eval session
(define V (literal-function 'V (-> (X Real Real) Real)))
((H-rectangular 'm V) (up 't (up 'x 'y) (down 'p_x 'p_y)))
((Lagrangian->Hamiltonian (L-rectangular 'm V)) (up 't (up 'x 'y) (down 'p_x 'p_y)))]

@sicm{3.1, pp. 204 and 213}}

@defproc[((L-axisymmetric-top [A scalar] [C scalar] [gMR scalar]) [local local-tuple]) scalar]{

A symmetric top with a fixed tip, in Euler angles θ, φ and ψ: A and C are the moments of inertia
about the tip, C that about the axis, and gMR is the weight times the distance of the centre of
mass.

@examples[#:eval session
((L-axisymmetric-top 'A 'C 'gMR)
 (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
((Lagrangian->Hamiltonian (L-axisymmetric-top 'A 'C 'gMR))
 (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))]

@sicm{3.4, p. 229}}

@defproc[(H-pend-sysder [m scalar] [l scalar] [g scalar] [A scalar] [omega scalar]) procedure?]{

The state derivative, by coordinate and momentum, of @racket[L-periodically-driven-pendulum],
the pendulum with a shaken pivot.

@examples[#:eval session
((H-pend-sysder 'm 'l 'g 'A 'omega) (up 't 'theta 'p_theta))
((state-advancer H-pend-sysder 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
 (up 0 1.0 0.0) 1.0 1e-12)]

@sicm{3.5, p. 237}}

@defproc[((monitor-p-theta [win frame?]) [state structure?]) any]{

A monitor for @racket[evolve] that draws the momentum of a pendulum against its angle, between
−π and π, as a point. @racketmodname[mechanics/plot] is loaded when the first point is drawn.

@examples[#:eval session
(define plot-win (frame :-pi :pi -10 10 #:width 400 #:height 400))
(define last-state
  ((evolve H-pend-sysder 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
   (up 0 1.0 0.0) (monitor-p-theta plot-win) 0.01 100.0 1e-12))
plot-win]

@sicm{3.5, p. 238}}

@(close-session session)
