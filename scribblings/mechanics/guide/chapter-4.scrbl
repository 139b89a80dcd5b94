#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../eval.rkt" "../citation.rkt"
          (only-in "../look/look.rkt" formula)
          "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "chapter-4"]{Along with chapter 4 of the book}

@(define session (make-session '(require mechanics/book mechanics/plot)))

What to type while reading @|the-book| from section 3.6 on, where surfaces of section begin, to the
end of chapter 4, on the structure of phase space, and what comes back.
@secref["chaos-guide"] tells the same story of one system, and says how far each number is to be
believed.

@racketblock[(require mechanics/book mechanics/plot)]

@section{3.6 Surfaces of section: Hénon and Heiles}

A section turns a motion into a map of the plane: from one crossing to the next. A map takes two
numbers, a procedure to call with the image, and one to call where there is no image. The section
of a driven system is a look once in each period of the drive:

@examples[#:eval session #:label #f
(define fast (* 4.2 (sqrt 9.8)))
((driven-pendulum-map 1.0 1.0 9.8 0.05 fast) 1.0 0.0 list void)]

Where the energy is conserved, a surface in phase space takes the place of the period. The section
of Hénon and Heiles is where a particle in their potential passes @formula{x = 0} to the right;
@formula{y} and its momentum are the coordinates there, and the energy gives the momentum that is
left. Three orbits of one energy, of which the first two lie on curves and the third fills an area:

@examples[#:eval session #:label #f
(HHpotential (up 't (up 'x 'y) (down 'p_x 'p_y)))
(section->state 1/8 0.1 0)
(explore-map (frame -0.5 0.7 -0.6 0.6 #:width 350 #:height 300)
             (HHmap 1/8 0.1 1e-10 1e-12) 300
             #:starts (list (up 0.2 0) (up 0 0.3) (up -0.1 0)))]

The section of a system of your own is made of its state derivative and an event.
@racket[Poincare-map] gives the state at the next crossing:

@examples[#:eval session #:label #f
(define to-the-right
  (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising))
(define next (Poincare-map (HHsysder) to-the-right))
(next (section->state 1/8 0.1 0))]

@section{3.9 The standard map}

A rotor that is kicked once in each period, by a force that goes as the sine of its angle. Between
the kicks it turns freely, so that the map is a formula:

@examples[#:eval session #:label #f
((standard-map 0.6) 1 2 list void)
(explore-map (frame 0 :2pi 0 :2pi #:width 300 #:height 300)
             (standard-map 0.6) 400
             #:starts (list (up 2 0.1) (up 0.1 0.1) (up 0 2.2)
                            (up 0 2.8) (up 2 :pi)))]

Areas are kept, whatever the kick: the determinant of the derivative is 1.

@examples[#:eval session #:label #f
(define ((kicked K) p)
  (define I (+ (ref p 1) (* K (sin (ref p 0)))))
  (up (+ (ref p 0) I) I))
(define slope ((D (kicked 'K)) (up 'theta 'I)))
slope
(prove-zero (- (determinant slope) 1))]

@section{4.1 The divided phase space}

Without kicks each orbit stays at its momentum. With weak ones most do nearly so, but about some
orbits islands appear, and chaos between them. The stronger the kick, the larger the chaotic zones:
orbits are regular where it is blue, and chaotic where it is yellow.

@examples[#:eval session #:label #f
(chaos-map (frame 0 :2pi 0 :2pi #:width 250 #:height 250)
           (standard-map 0.6) 200 #:samples 80)
(chaos-map (frame 0 :2pi 0 :2pi #:width 250 #:height 250)
           (standard-map 1.4) 200 #:samples 80)]

@section{4.2 Linear stability}

A fixed point of a map is a motion that comes back. The eigenvalues of the map's derivative there,
its multipliers, tell what becomes of a small displacement: on the unit circle it turns, off it it
grows.

@examples[#:eval session #:label #f
(find-fixed-point (standard-map 0.6) (up 0.1 0.1))
(find-fixed-point (standard-map 0.6) (up 3 0.1))
(fixed-point-eigen (standard-map 0.6) 0 0 1e-10 list)]

With symbols: near the point at @formula{θ = π} the trace is @formula{2 − K}, so that it is stable
as long as @formula{K} is less than 4.

@examples[#:eval session #:label #f
(define at-pi ((D (kicked 'K)) (up :pi 0)))
(+ (ref at-pi 0 0) (ref at-pi 1 1))
(define (kind K) (fixed-point-kind (find-fixed-point (standard-map K) (up 3 0.1))))
(list (kind 0.6) (kind 3.9) (kind 4.1))]

Of a motion with a period, the multipliers come from the equation of variations. A pendulum upside
down, with its pivot at rest and shaken fast:

@examples[#:eval session #:label #f
(define (upright amplitude frequency)
  (Floquet-multipliers (H-pend-sysder 1 1 9.8 amplitude frequency)
                       (up 0 :pi 0) (/ :2pi frequency)))
(upright 0.0 fast)
(map magnitude (upright 0.2 (* 20 (sqrt 9.8))))]

@section{4.3 The homoclinic tangle}

The points that come to an unstable fixed point make up its stable manifold, those that come from
it the unstable one. They begin in the directions of the multipliers. A branch is a curve with a
parameter, drawn with as many points as it takes; the stable manifold is the unstable one of the
inverse map.

@examples[#:eval session #:label #f
(define (branch T)
  (fixed-point-eigen T 0 0 1e-10
    (lambda (A dx dy B ex ey)
      (unstable-manifold T 0 0 dx dy A 1e-8))))
(define tangle (frame 0 :2pi 0 :2pi #:width 300 #:height 300))
(define on-circle (principal-value :2pi))
(define (draw curve color)
  (define (point u) (up (on-circle (ref (curve u) 0)) (on-circle (ref (curve u) 1))))
  (plot-parametric-fill tangle point 0.1 1000 (torus-near? 0.05) #:color color))
(draw (branch (standard-map 1.4)) 'red)
(draw (branch (standard-map-inverse 1.4)) 'blue)
tangle]

Where the two manifolds cross once they cross without end, for the image of a crossing is a
crossing. The first ones:

@examples[#:eval session #:label #f
(define saddle (find-fixed-point (standard-map 1.4) (up 0 0)))
(homoclinic-points (standard-map 1.4) saddle #:inverse (standard-map-inverse 1.4)
                   #:stable-branch -1 #:length 5)]

@section{4.4 Integrable systems}

An orbit on a curve goes round it by so many turns in each step, its rotation number. Where a
system is integrable all orbits lie on curves; their rotation numbers change from curve to curve,
and those with a rational one consist of orbits that close. Of the standard map without kicks, and
with them:

@examples[#:eval session #:label #f
(rotation-number (standard-map 0.0) (up 0 2))
(/ 2 :2pi)
(rotation-number (standard-map 0.6) (up 0 2))
(rotation-number (standard-map 0.6) (up 0.1 0.1))]

@section{4.5 Poincaré, Birkhoff, and chains of islands}

When a system is disturbed, the curves of closed orbits break up. Of all points of one a few are
left, by turns stable and unstable. They are found where points that the map moves radially lie on
the image of their curve. Here are those that come back after three steps:

@examples[#:eval session #:label #f
(define thrice (iterated-map (standard-map 0.6) 3))
(define J (radially-mapping-points thrice 1.6 2.4 1.0 1e-12))
(thrice 1.0 J list void)
(define three (periodic-points (standard-map 0.6) 3 (list 0 :2pi 1.5 2.7)))
(map fixed-point-kind three)
(map fixed-point-coordinates three)]

@section{4.6 Invariant curves and the KAM theorem}

A curve whose rotation number is far from all fractions with small denominators survives a weak
disturbance: that is what Kolmogorov, Arnold and Moser proved. The golden ratio is the farthest. On
its curve points have the order of a rotation; a point beside it is ahead or behind, and bisection
finds the curve. Newton's method for its Fourier series finds it to rounding:

@examples[#:eval session #:label #f
(define golden (- 1 (/ 1 golden-ratio)))
(define (side I) (which-way? golden 0 I (standard-map 0.95)))
(list (side 2.0) (side 2.2))
(find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-8)
(define circle (invariant-circle (standard-map 0.95) golden))
(invariant-circle-ordinate circle 0)]

No orbit crosses it. Beyond @formula{K = 0.9716} it is gone, and what is asked for is not found:

@examples[#:eval session #:label #f
(eval:error (invariant-circle (standard-map 1.1) golden #:most-modes 256))]

@section{Figures and exercises of the chapter}

Each figure that has a system to be computed is a program: @secref["chapter-4-figures"] lists those
of the chapter, @secref["chapter-3-figures"] those of 3.6 to 3.9. So is each exercise:
@secref["guide-exercises"].

@next-pages["chaos-guide" "one system, from phase portrait to tangle, and how far numbers are right"
            "guide-exercises" "its exercises"
            "chapter-5" "canonical transformations"]

@(close-session session)
