#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt" "../next-pages.rkt")

@title[#:tag "geometry-stories"]{A sphere, a black hole, the rotations}

@(define session (make-session '(require mechanics/geometry)))

Three spaces, and what moves freely in them.

@section{Great circles}

A bead on a smooth sphere, without weight. Its Lagrangian is made of the metric, which is that of
the space around:

@examples[#:eval session #:label #f
(define-coordinates (up theta phi) S2-spherical)
(define S2-basis (coordinate-system->basis S2-spherical))
((metric->components S2-metric S2-basis) ((point S2-spherical) (up 'theta 'phi)))
(define L (metric->Lagrangian S2-metric S2-spherical))
(((Lagrange-equations L) (up (literal-function 'theta) (literal-function 'phi))) 't)]

The connection says the same without a Lagrangian, in an @racket[up]:

@examples[#:eval session #:label #f
(define sphere (metric->Cartan S2-metric S2-basis))
(define path
  (compose (point S2-spherical) (up (literal-function 'theta) (literal-function 'phi))
           (chart R1-rect)))
((((geodesic-equation R1-rect S2-spherical sphere) path) (chart S2-spherical))
 ((point R1-rect) 't))]

Coordinates are no obstacle for the bead. It goes over the pole, where the longitude has no
meaning, and another chart takes over there:

@examples[#:eval session #:label #f
(define motion (evolve-geodesic S2-metric S2-spherical (up 0 (up 1 0) (up -1 0)) 2))
(coordinate (motion 2))
(trajectory-chart-changes motion)]

A vector carried around the circle of colatitude 1 comes back turned, by 2π(1 − cos 1): that is the
area of the cap, since the curvature is 1.

@examples[#:eval session #:label #f
(define carried
  (evolve-parallel-transport S2-metric S2-spherical (lambda (t) (up 1 t)) (up 1 0) 0 (* 2 pi)))
(ref (coordinate (carried (* 2 pi))) 0)
(cos (* 2 pi (- 1 (cos 1))))
(verify-equal (scalar-curvature S2-metric S2-basis) 2)]

@section{A black hole}

Schwarzschild's metric, with the mass as a length m = GM/c² and the time in units of length:

@examples[#:eval session #:label #f
(define-coordinates (up t r Theta Phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define a (- 1 (/ (* 2 'm) r)))
(define (black-hole u v)
  (+ (* -1 a (dt u) (dt v)) (* (/ 1 a) (dr u) (dr v))
     (* (square r) (+ (* (dTheta u) (dTheta v)) (* (square (sin Theta)) (dPhi u) (dPhi v))))))]

It is empty space: Ricci's tensor vanishes, which is proved. It is not flat:

@examples[#:eval session #:label #f
(define connection (metric->Cartan black-hole basis))
(define nabla (covariant-derivative connection))
(verify-equal (Ricci nabla basis) 0)
(((Riemann nabla) dt d/dr d/dt d/dr) ((point spacetime-sphere) (up 't 'r 'theta 'phi)))]

With one factor wrong it would not be empty:

@examples[#:eval session #:label #f
(define (wrong u v) (+ (black-hole u v) (* a (dt u) (dt v)) (* -1 (square a) (dt u) (dt v))))
(verdict-status (verify-equal (Ricci (covariant-derivative (metric->Cartan wrong basis))) 0))]

A circular orbit at the angular velocity ω is a geodesic if ω² r³ = m, Kepler's law to the letter:

@examples[#:eval session #:label #f
(define (orbit omega)
  (compose (point spacetime-sphere) (lambda (s) (up s 'r (/ ':pi 2) (* omega s))) (chart R1-rect)))
(define (residual omega)
  ((((geodesic-equation R1-rect spacetime-sphere connection) (orbit omega))
    (chart spacetime-sphere))
   ((point R1-rect) 's)))
(simplify (ref (residual 'omega) 1))
(verify-equal (residual (sqrt (/ 'm (cube 'r)))) (up 0 0 0 0))]

@section{The rotations}

Turning about the axes of space moves a rotation along three vector fields, which are no
coordinate basis: they do not commute.

@examples[#:eval session #:label #f
(define-coordinates (up th ph ps) Euler-angles)
(define e_x (+ (* (cos ph) d/dth) (* -1 (/ (* (sin ph) (cos th)) (sin th)) d/dph)
               (* (/ (sin ph) (sin th)) d/dps)))
(define e_y (+ (* (sin ph) d/dth) (* (/ (* (cos ph) (cos th)) (sin th)) d/dph)
               (* -1 (/ (cos ph) (sin th)) d/dps)))
(define e_z d/dph)
(verify-equal (commutator e_x e_y) (- e_z))
(verify-equal (commutator e_y e_z) (- e_x))]

The metric in which they are orthonormal is that of a body whose moments of inertia are all equal.
Its geodesics are steady rotations, about any axis: these fields are Killing's, and their own
derivative vanishes.

@examples[#:eval session #:label #f
(define dual (vector-basis->dual (down e_x e_y e_z) Euler-angles))
(define (rotor u v)
  (apply + (for/list ([w (structure->list dual)]) (* (w u) (w v)))))
(define SO3-basis (coordinate-system->basis Euler-angles))
(define g (components->metric (metric->components rotor SO3-basis) SO3-basis))
(define along (covariant-derivative (metric->Cartan g SO3-basis)))
(define axis (+ (* 'a e_x) (* 'b e_y) (* 'c e_z)))
(verify-equal ((along axis) axis) 0)
(verify-equal ((Lie-derivative e_x) g) 0)
(verify-equal (scalar-curvature g SO3-basis) 3/2)]

@next-pages["geometry-guide" "the book, chapter by chapter"
            "chapter-2" "rigid bodies"
            "reference-fields" "vector fields and forms"]

@(close-session session)
