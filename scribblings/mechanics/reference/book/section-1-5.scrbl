#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-1-5"]{1.5 The Euler–Lagrange equations}

@(define session (make-session '(require mechanics/book)))

@defproc[(proposed-solution [t scalar]) scalar]{

The oscillation a cos(ωt + φ), with symbols for amplitude, frequency and phase.

@examples[#:eval session
(((Lagrange-equations (L-harmonic 'm 'k)) proposed-solution) 't)]

@sicm{p. 36}}

@defproc[((L-central-polar [m scalar] [U procedure?]) [local local-tuple]) scalar]{

A particle in a plane in polar coordinates (r, φ), with the potential energy U(r).

@examples[#:eval session
(define path (up (literal-function 'r) (literal-function 'phi)))
(((Lagrange-equations (L-central-polar 'm (literal-function 'U)))
  path)
 't)]

@sicm{pp. 36 and 43}}

@defproc[((gravitational-energy [G scalar] [m1 scalar] [m2 scalar]) [r scalar]) scalar]{

The potential energy −G m@subscript{1} m@subscript{2}/r of two masses that attract each other.

@examples[#:eval session ((gravitational-energy 'G 'm_1 'm_2) 'r)]

@sicm{p. 37}}

@defproc[((L-Kepler-polar [GM scalar] [m scalar]) [local local-tuple]) scalar]{

A planet of mass m in the plane of its orbit, about a sun that stays at rest and attracts
with the strength @racket[GM].

@examples[#:eval session
(((Lagrange-equations (L-Kepler-polar 'GM 'm)) path) 't)
(define (circle t) (up 'R (* 'Omega t)))
(verify-solution (L-Kepler-polar (* (square 'Omega) (cube 'R)) 'm)
                 circle)]}

@(close-session session)
