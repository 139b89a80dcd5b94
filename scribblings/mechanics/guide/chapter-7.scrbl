#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../eval.rkt" "../citation.rkt"
          (only-in "../program.rkt" program program-link)
          "../next-pages.rkt")

@title[#:tag "chapter-7"]{Along with chapter 7 of the book}

@(define session (make-session '(require mechanics/book) '(define a-state (up 't 'theta 'p))))

What to type while reading chapter 7 of @|the-book|, on perturbation theory, and what comes back.

@racketblock[(require mechanics/book)]

@section{7.2 The pendulum as a perturbed rotor}

The book's W removes the first order, and leaves what is of the second:

@examples[#:eval session #:label #f
((+ ((Lie-derivative (W 'alpha 'beta)) (H0 'alpha)) (H1 'beta)) a-state)
(series:sum (((exp (* 'epsilon (Lie-derivative (W 'alpha 'beta))))
              (H-pendulum-series 'alpha 'beta 'epsilon))
             a-state)
            2)
((C-inv 1 0.1 1 2) (up 0 0 0.7))]

@racket[perturbation-series] finds the generators, order by order, and what was divided by:

@examples[#:eval session #:label #f
(define P (perturbation-series (H0 'alpha) (H1 'beta) a-state #:order 4))
P
((car (perturbation-generators P)) a-state)
(verify-perturbation P)
(for ([v (perturbation-verdicts P)] #:when (= (cadr v) 4))
  (printf "~a, order 4: ~a\n" (car v) (verdict-status (caddr v))))]

Against the pendulum in closed form: the frequency at the action 3, for β = 0.3.

@examples[#:eval session #:label #f
(define Q (perturbation-series (H0 1) (H1 1) a-state #:order 4 #:parameter 0.3))
(define (energy I) (series:sum ((perturbation-Hamiltonian Q) (up 0 0 I)) 4))
((D energy) 3.0)
(pendulum-frequency 1 0.3 ((pendulum-circulating-action-to-E 1 0.3) 3.0))]

Near the separatrix it is worth nothing, and on the resonance it divides by zero:

@examples[#:eval session #:label #f
(eval:error ((perturbation-inverse Q) (up 0 1.0 0)))]

@section{Figures up to 7.7}

The series summed up to more and more terms, @program-link["figures/figure-7-1.rkt"]; beside the
pendulum, @program-link["figures/figure-7-2.rkt"]; where it does not converge,
@program-link["figures/figure-7-3.rkt"], below the separatrix,
@program-link["figures/figure-7-4.rkt"].
Two steps, @program-link["figures/figure-7-5.rkt"], go wrong with the time,
@program-link["figures/figure-7-6.rkt"], unless the mean is kept,
@program-link["figures/figure-7-7.rkt"]:

@(program "figures/figure-7-7.rkt" #'here)

The second generator has a minus before sin 2θ, as (7.28) asks; (7.29) and (7.32) print a plus.

@section[#:tag "driven-pendulum"]{7.3 to 7.4.5 The driven pendulum}

With the time as an angle φ = ωt the drive is two more waves. Each of the three has a resonance,
where its frequency is zero:

@examples[#:eval session #:label #f
(define (rotor-and-clock (up t (up phi theta) (down P p)))
  (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (waves (up t (up phi theta) (down P p)))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
(define state (up 's (up 'phi 'theta) (down 'P 'p)))
(perturbation-divisors (perturbation-series rotor-and-clock waves state))
(define near (perturbation-series rotor-and-clock waves state #:order 2 #:keep '((1 -1))))
(perturbation-resonances near)
(verify-perturbation near)]

How wide they are, how they look beside the section of the pendulum, when they overlap, and how the
pendulum comes to stand on its head is told in @secref["resonances-guide"], with figures 7.8 to
7.15.

@section{Normal forms}

Near an equilibrium there is no small parameter but the distance. The Hamiltonian of Hénon and
Heiles, whose two frequencies are in resonance:

@examples[#:eval session #:label #f
(define (Henon-Heiles (up t (up x y) p))
  (+ (* 1/2 (+ (square p) (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))
(define N (Birkhoff-normal-form Henon-Heiles (up 't (up 'x 'y) (down 'p_x 'p_y)) #:degree 6))
(normal-form-resonances N)
(verify-normal-form N)]

@next-pages["guide-exercises" "its exercises"
            "resonances-guide" "the islands of a section, computed"
            "reference-canonical" "every name about perturbations"]

@(close-session session)
