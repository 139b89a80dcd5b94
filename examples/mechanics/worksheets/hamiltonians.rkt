#lang mechanics/worksheet
;; SICM 3.1 to 3.2: from a Lagrangian to Hamilton's equations.

(title "Hamilton's equations")

(text "A pendulum of mass m and length l under gravity g; `theta` is the angle from the lowest "
      "point, `p_theta` its momentum.")

(given
 (define (L (up t theta thetadot))
   (+ (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta)))))

(define (H (up t theta p))
  (- (/ (square p) (* 2 'm (square 'l))) (* 'm 'g 'l (cos theta))))

(exercise momentum-of-bob function "The momentum, as a function of the local tuple."
  (coordinates theta)
  (key (lambda ((up t theta thetadot)) (* 'm (square 'l) thetadot)))
  (points 1))

(exercise H-pendulum Hamiltonian "The Hamiltonian."
  (coordinates theta) (key H) (points 2)
  (slip (lambda ((up t theta p))
          (+ (/ (square p) (* 2 'm (square 'l))) (* 'm 'g 'l (cos theta))))
        "What is the potential energy at the highest point?"))

(exercise rates expression "Hamilton's equations: (up Dtheta Dp)."
  (arguments theta p)
  (key (lambda (theta p) (up (/ p (* 'm (square 'l))) (* -1 'm 'g 'l (sin theta)))))
  (points 2))

(exercise integral conserved "A conserved quantity, as a function of the state."
  (coordinates theta) (of-Hamiltonian H) (key H) (points 1))

(exercise bracket expression "The Poisson bracket of `theta` with `(square p)`."
  (arguments theta p)
  (key (lambda (theta p) (* 2 p)))
  (points 1))
