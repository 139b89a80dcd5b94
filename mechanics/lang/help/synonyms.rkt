#lang racket/base
;; Words of the field for one thing: who looks for one of them also finds, less high, texts with
;; another.  And phrases that stand for others.

(provide same-words phrases)

;; Any of these stands for any other.
(define same-words
  '("damping friction drag dissipation viscous"
    "plot draw graph picture"
    "animation movie video"
    "planet orbit kepler gravitation"
    "satellite moon planet"
    "oscillator spring"
    "oscillation vibration"
    "pendulum swing"
    "top gyroscope"
    "frame axes"
    "wire ring hoop track"
    "stability stable unstable"
    "equilibrium equilibria rest"
    "chaos chaotic"
    "invariant kam"
    "invariant conserved constant"
    "coordinates variables"
    "derivative differentiate differentiation"
    "axis axes"
    "invert inverse"
    "error mistake message"
    "tex latex"
    "save write"
    "install installation setup"
    "exercise ex problem"
    "equation eq"
    "figure fig"
    "chapter ch"
    "method integrator solver"
    "homework worksheet assignment"
    "grade grading check"
    "begin start"
    "teacher instructor class"
    "quick fast speed slow"
    "tuple structure"
    "perturbation resonance"))

;; (words others): where a question has the words beside each other, it is taken for the others.
(define phrases
  '(("air resistance" "drag")
    ("surface section" "poincare section")
    ("initial condition" "evolve state")
    ("initial value" "evolve state")
    ("solve differential equation" "evolve trajectory")
    ("differential equation" "equation motion")
    ("ode" "evolve trajectory")
    ("runge kutta" "integration method")
    ("rk4" "integration method")
    ("spinning top" "heavy top")
    ("rotating frame" "rotating axes")
    ("least action" "action path")
    ("lagrange multiplier" "multiplier")
    ("eom" "equation motion")
    ("shm" "harmonic oscillator")
    ("simple harmonic" "harmonic oscillator")
    ("python" "export python")
    ("coriolis" "rotating axes")
    ("centrifugal" "rotating axes")
    ("tutorial" "begin")
    ("getting started" "begin")
    ("start" "begin")
    ("simulate" "evolve trajectory")
    ("simulation" "evolve trajectory")
    ("time step" "step integration method")
    ("parallel transport" "transport")
    ("parallel" "cores ensemble")
    ("matlab" "formula manipulator")
    ("mathematica" "formula manipulator")
    ("wolfram" "formula manipulator")
    ("maxima" "formula manipulator")
    ("sympy" "formula manipulator")
    ("scipy" "evolve trajectory")
    ("kolmogorov" "kam")
    ("lagrange point" "triangle points")
    ("l4" "triangle points")
    ("orbital element" "kepler orbit")
    ("kepler element" "kepler orbit")
    ("export plot" "save picture")
    ("substitute number" "substitute")
    ("type formula" "read-infix")
    ("formula paper" "read-infix")))
