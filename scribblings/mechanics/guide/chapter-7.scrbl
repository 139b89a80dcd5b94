#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../eval.rkt" "../citation.rkt"
          (only-in "../program.rkt" program-link))

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
(verify-perturbation P)]

Against the pendulum in closed form: the frequency at the action 3, for β = 0.3.

@examples[#:eval session #:label #f
(define Q (perturbation-series (H0 1) (H1 1) a-state #:order 4 #:parameter 0.3))
(define (energy I) (series:sum ((perturbation-Hamiltonian Q) (up 0 0 I)) 4))
((D energy) 3.0)
(pendulum-frequency 1 0.3 ((pendulum-circulating-action-to-E 1 0.3) 3.0))]

Near the separatrix it is worth nothing, and on the resonance it divides by zero:

@examples[#:eval session #:label #f
(eval:error ((perturbation-inverse Q) (up 0 1.0 0)))]

@section[#:tag "driven-pendulum"]{7.4 The driven pendulum}

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
(for/list ([k '((0 1) (1 1) (1 -1))])
  (list k (resonance-center rotor-and-clock k state 1)))]

Near one of them its wave is kept. What is left is a pendulum, of which the separatrix bounds the
resonance:

@examples[#:eval session #:label #f
(define near (perturbation-series rotor-and-clock waves state #:order 2 #:keep '((1 -1))))
(perturbation-resonances near)
(verify-perturbation near)
(ref (resonance-width rotor-and-clock waves '(1 -1) state) 1)]

The section of figure 7.9 with these bounds drawn over it is
@program-link["figures/figure-7-9.rkt"].

@section{7.5 The vertically driven pendulum}

Is the pendulum that stands on its head stable when its pivot is shaken fast? Now only the clock
is fast. With H@subscript{0} = ωP all waves that hold φ are removed, and those of θ alone stay,
resonances all of them: the averaged Hamiltonian.

@examples[#:eval session #:label #f
(define (clock (up t q (down P p))) (* 'omega P))
(define (shaken (up t (up phi theta) (down P p)))
  (+ (/ (square p) (* 2 'alpha))
     (* -1 'beta (cos theta))
     (* 'gamma (cos theta) (cos phi))))
(define averaged (perturbation-series clock shaken state #:order 3))
(verify-perturbation averaged)
(define (potential theta)
  (series:sum ((perturbation-Hamiltonian averaged) (up 0 (up 0 theta) (down 0 0))) 3))
(potential 'theta)
(((expt D 2) potential) 'theta)]

At the top cos θ = −1, so the pendulum stands if γ² > 2αβω² (ε being 1): with γ = mlAω²,
α = ml² and β = mgl that is A²ω² > 2gl. One period of the real motion agrees:
with ω = 100√9.8 and A = 0.03 the trace of its derivative at the top is within −2 and 2.

@examples[#:eval session #:label #f
(define (trace-at-the-top A omega)
  (define ((flow) (up t theta p))
    (up 1 p (* -1 (- 9.8 (* A (square omega) (cos (* omega t)))) (sin theta))))
  (define M
    ((D-as-matrix (lambda (s) ((state-advancer flow) s (/ (* 2 pi) omega) 1e-12)))
     (up 0 pi 0.0)))
  (trace (qp-submatrix M)))
(trace-at-the-top 0.03 (* 100 (sqrt 9.8)))
(trace-at-the-top 0.01 (* 100 (sqrt 9.8)))]

@section{Normal forms}

Near an equilibrium there is no small parameter but the distance. The Hamiltonian of Hénon and
Heiles, whose two frequencies are in resonance:

@examples[#:eval session #:label #f
(define (Henon-Heiles (up t (up x y) p))
  (+ (* 1/2 (+ (square p) (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))
(define N (Birkhoff-normal-form Henon-Heiles (up 't (up 'x 'y) (down 'p_x 'p_y)) #:degree 6))
(normal-form-resonances N)
(verify-normal-form N)]

@(close-session session)
