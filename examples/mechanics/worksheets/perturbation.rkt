#lang mechanics/worksheet
;; SICM 7.1 to 7.4: perturbation theory by Lie series, and resonances.

(title "The pendulum as a perturbed rotor")

(text "A pendulum that turns fast is a rotor with a small disturbance: its Hamiltonian is "
      "`(- (/ (square p) (* 2 alpha)) (* epsilon beta (cos theta)))` with a small `epsilon`; "
      "`alpha` and `beta` are positive. A Lie transform with the generator `epsilon` W, "
      "F + `epsilon` {F, W} + ..., is to leave no angle in it.")

(define (H0 (up t theta p)) (/ (square p) (* 2 'alpha)))
(define (H1 (up t theta p)) (* -1 'beta (cos theta)))
(define rotor (perturbation-series H0 H1 (up 't 'theta 'p_theta) #:order 2))

(exercise generator Hamiltonian "The generator W that does so to first order, 0 on average."
  (coordinates theta)
  (key (list-ref (perturbation-generators rotor) 0)) (points 2)
  (hint "H1 + {H0, W} = 0, where H1 is what `epsilon` multiplies."))

(exercise second-order expression
  "The term of the new Hamiltonian with `(square epsilon)`, in its momentum p."
  (arguments p)
  (key (lambda (p) (/ (* 'alpha (square 'beta)) (* 4 (square p))))) (points 3)
  (slip (lambda (p) (/ (* 'alpha (square 'beta)) (* 2 (square p))))
        "That is {H1, W}; the series of H0 brings half of it back." #:credit 1/2)
  (hint "What of {H1, W} + 1/2 {{H0, W}, W} does not depend on the angle?"))

(exercise rate expression "With this term, the rate at which the new angle grows."
  (arguments p)
  (key (lambda (p) (- (/ p 'alpha)
                      (* (square 'epsilon) (/ (* 'alpha (square 'beta)) (* 2 (cube p)))))))
  (points 2))

(exercise half-width expression
  "Near p = 0 this fails, for there the pendulum swings: up to which p?"
  (assuming '(> alpha 0) '(> beta 0) '(> epsilon 0))
  (key (* 2 (sqrt (* 'alpha 'beta 'epsilon)))) (points 2)
  (slip (* 4 (sqrt (* 'alpha 'beta 'epsilon))) "That is the whole width, from -p to p."))

(exercise softening expression
  "The frequency of swings of a small amplitude a, if `omega_0` is that of yet smaller ones."
  (arguments a)
  (key (lambda (a) (* 'omega_0 (- 1 (/ (square a) 16))))) (points 2)
  (slip (lambda (a) (* 'omega_0 (+ 1 (/ (square a) 16)))) "Wide swings take longer.")
  (hint "What is the average of the fourth power of a cosine?"))

(text "If its support shakes fast, with frequency `omega`, the slow motion of a pendulum has the "
      "Hamiltonian `(+ (/ (square p) (* 2 alpha)) (* -1 beta (cos theta)) "
      "(* (/ (square gamma) (* 2 alpha (square omega))) (cos (* 2 theta))))`.")

(exercise upright expression "The `gamma` from which on it stands upright, at `theta` = `pi`."
  (assuming '(> alpha 0) '(> beta 0) '(> omega 0))
  (key (* 'omega (sqrt (* 'alpha 'beta)))) (points 2)
  (hint "Where has the potential energy a minimum?"))

(exercise why reason "Why does a generator help little where the frequency is near 0?")
