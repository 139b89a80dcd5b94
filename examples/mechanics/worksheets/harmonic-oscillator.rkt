#lang mechanics/worksheet
;; SICM 1.4 and 1.5: the harmonic oscillator.

(title "The harmonic oscillator")

(text "A mass m on a spring of stiffness k; its elongation is x.")

(given
 (define ((T m) (up t x v)) (* 1/2 m (square v)))
 (define ((V k) (up t x v)) (* 1/2 k (square x))))

(define L (- (T 'm) (V 'k)))

(exercise L-oscillator Lagrangian "A Lagrangian of the oscillator."
  (coordinates x) (key L) (points 1)
  (slip (+ (T 'm) (V 'k)) "That is the energy; a Lagrangian is T - V."))

(exercise equation equations "Its equation of motion."
  (coordinates x) (of L) (points 2))

(exercise frequency expression "The angular frequency, in m and k."
  (key (sqrt (/ 'k 'm)))
  (slip (sqrt (/ 'm 'k)) "That is the reciprocal: a stiffer spring swings faster.")
  (slip (/ 'k 'm) "That is its square.")
  (points 1))

(exercise released solution "The motion of a mass released at rest at `x0` when t = 0."
  (coordinates x) (of L) (starts (up 0 'x0 0))
  (key (lambda (t) (* 'x0 (cos (* (sqrt (/ 'k 'm)) t)))))
  (points 2))

(exercise energy conserved "A quantity that keeps its value."
  (coordinates x) (of L) (key (Lagrangian->energy L)) (points 2))
