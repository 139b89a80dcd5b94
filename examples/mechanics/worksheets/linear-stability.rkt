#lang mechanics/worksheet
;; SICM 4.2: linear stability of equilibria, and of fixed points of maps.

(title "Linear stability")

(text "A pendulum of length l with a bob of mass m stands on its head under gravity g. The small "
      "angle between the upright and the rod is x.")

(define (upright (up t x v))
  (+ (* 1/2 'm (square (* 'l v))) (* 1/2 'm 'g 'l (square x))))

(define (rate) (sqrt (/ 'g 'l)))

(exercise equation-upright equations "The equation of motion, to the first order in x."
  (coordinates x) (of upright) (points 2)
  (slip (lambda (x) (lambda (t) (+ (* 'l (((expt D 2) x) t)) (* 'g (x t)))))
        "That is the pendulum that hangs: it comes back."))

(exercise exponents expression
  "The characteristic exponents of the equilibrium: (up growing shrinking)."
  (key (up (rate) (- (rate)))) (points 2)
  (slip (up (sqrt (/ 'l 'g)) (- (sqrt (/ 'l 'g)))) "Those are times; an exponent is a rate."))

(exercise settling solution "The motion from `x0` at t = 0 that comes to rest upright."
  (coordinates x) (of upright)
  (starts (up 0 'x0 (* -1 (rate) 'x0)))
  (key (lambda (t) (* 'x0 (exp (* -1 (rate) t))))) (points 2)
  (hint "Which of the two exponentials must be absent?"))

(text "The standard map takes `theta` and `I` to `(+ theta I1)` and `I1`, where "
      "I1 = `(+ I (* K (sin theta)))`, with K > 0. Where I = 0 it has two fixed points.")

(exercise traces expression
  "The traces of its derivative: (up at-0 at-pi), for `theta` = 0 and `theta` = `pi`."
  (key (up (+ 2 'K) (- 2 'K))) (points 2)
  (hint "Differentiate both components by both arguments; I1 depends on `theta`, too."))

(exercise multipliers expression "The multipliers at `theta` = 0: (up larger smaller)."
  (assuming '(> K 0))
  (key (let ([root (sqrt (+ 'K (* 1/4 (square 'K))))])
         (up (+ 1 (* 1/2 'K) root) (+ 1 (* 1/2 'K) (- root)))))
  (points 3)
  (hint "Their sum is the trace, and their product 1, for the map preserves areas."))

(exercise limit number "The K up to which the fixed point at `theta` = `pi` is stable."
  (key 4) (within 1/1000) (points 1)
  (hint "Which traces belong to multipliers on the unit circle?"))

(exercise why reason "Why has a Hamiltonian system no equilibrium that attracts what is near it?")
