#lang mechanics/worksheet
;; SICM 1.4: actions, and the motion of a free particle.

(title "The free particle")

(text "A particle of mass m moves along a line, and no force acts on it. Its action on a path "
      "`x` is the integral of the Lagrangian along it.")

(define (L (up t x v)) (* 1/2 'm (square v)))
(define (straight t) (+ 'x0 (* 'v0 t)))

(exercise L-free Lagrangian "A Lagrangian of the particle."
  (coordinates x) (key L) (points 1))

(exercise straight-action expression
  "The action from t = 0 to t = `T` on the straight path from 0 to `d`, in m, d and T."
  (key (/ (* 1/2 'm (square 'd)) 'T))
  (points 2)
  (slip (* 1/2 'm (square 'd) 'T) "The speed on this path is d/T.")
  (hint "What is the velocity on this path?"))

(exercise bent-action expression
  "The action on `(* d (square (/ t T)))` between the same ends."
  (key (/ (* 2/3 'm (square 'd)) 'T))
  (points 2)
  (hint "It must be larger than that of the straight path."))

(exercise general-motion solution "The general motion, with constants `x0` and `v0`."
  (coordinates x) (of L) (constants x0 v0) (key straight) (points 2))

(exercise why reason "Why is the straight path the one with the least action?")
