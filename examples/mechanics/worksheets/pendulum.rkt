#lang mechanics/worksheet
;; SICM 1.6: the pendulum.

(title "The pendulum")

(text "A bob of mass m swings in a plane on a massless rod of length l under gravity g. "
      "The angle `theta` is measured from the lowest point.")

(given
 (define ((T m l) (up t theta thetadot))
   (* 1/2 m (square (* l thetadot)))))

(define ((V m l g) (up t theta thetadot)) (* -1 m g l (cos theta)))
(define L (- (T 'm 'l) (V 'm 'l 'g)))

(exercise L-bob Lagrangian "A Lagrangian of the bob."
  (coordinates theta) (key L) (points 2)
  (slip (+ (T 'm 'l) (V 'm 'l 'g)) "That is the energy; a Lagrangian is T - V." #:credit 1/2)
  (hint "With which sign does the potential energy enter a Lagrangian?"))

(exercise motion equations "The equation of motion: what is zero along each motion."
  (coordinates theta) (of L) (points 3)
  (slip (lambda (theta)
          (lambda (t) (+ (* 'l (((expt D 2) theta) t)) (* 'g (theta t)))))
        "That holds for small angles only." #:credit 1/3))

(exercise constant conserved "A quantity that keeps its value along every motion."
  (coordinates theta) (of L) (key (Lagrangian->energy L)) (points 2))

(exercise period number "The period of small oscillations, for l = 1 m and g = 9.81 m/s²."
  (key (* 2 pi (sqrt (/ 1 9.81)))) (unit "s") (within 1/100) (points 1))

(exercise why reason "Why does the mass not matter?")
