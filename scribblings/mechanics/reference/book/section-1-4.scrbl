#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-1-4"]{1.4 Computing actions}

@(define session (make-session '(require mechanics/book)))

@defproc[((L-free-particle [mass scalar]) [local local-tuple]) scalar]{

A free particle in rectangular coordinates, of any number: ½ m v·v.

@examples[#:eval session
((L-free-particle 'm) (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))]

@sicm{p. 14}}

@defproc[(test-path [t scalar]) structure?]{

A straight path in space at constant speed.

@examples[#:eval session
(test-path 't)
(Lagrangian-action (L-free-particle 3) test-path 0 10)]

@sicm{p. 18}}

@defproc[((varied-free-particle-action [mass scalar] [q path] [nu procedure?]
                                       [t1 real?] [t2 real?])
          [epsilon scalar])
         scalar]{

The action of a free particle from @racket[t1] to @racket[t2] along the path q + ε η, where
η is ν made to vanish at both ends by @racket[make-eta]. The straight path is the one of
least action:

@examples[#:eval session
(define action
  (varied-free-particle-action 3 test-path (up sin cos square) 0 10))
(action 0.001)
(minimize action -2 1)]

@sicm{p. 18}}

@defproc[((L-harmonic [m scalar] [k scalar]) [local local-tuple]) scalar]{

A harmonic oscillator of mass m and stiffness k, in any number of coordinates: ½ m v² − ½ k q².

@examples[#:eval session
((L-harmonic 'm 'k) (up 't 'x 'v))
(define q (find-path (L-harmonic 1 1) 0 1 :pi/2 0 3))
(- (q 1) (cos 1))]

@sicm{p. 22}}

@(close-session session)
