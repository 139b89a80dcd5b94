#lang mechanics/worksheet
;; SICM 1.6.2 to 1.6.4: the pendulum whose support moves.

(title "The driven pendulum")

(text "The support of a pendulum of mass m and length l moves up and down: its height is "
      "`(y t)`. The angle `theta` is measured from the lowest point; gravity is g.")

(given
 (define y (literal-function 'y)))

(define (L (up t theta thetadot))
  (+ (* 1/2 'm (+ (square (* 'l thetadot))
                  (* 2 'l thetadot ((D y) t) (sin theta))
                  (square ((D y) t))))
     (* 'm 'g (- (* 'l (cos theta)) (y t)))))

(exercise L-driven Lagrangian "A Lagrangian of the bob."
  (coordinates theta) (key L) (points 3)
  (hint "Where is the bob at the time t, in rectangular coordinates?"))

(exercise equation-driven equations "Its equation of motion."
  (coordinates theta) (of L) (points 3)
  (slip (lambda (theta)
          (lambda (t) (+ (* 'l (((expt D 2) theta) t)) (* 'g (sin (theta t))))))
        "That is the pendulum whose support is at rest."))

(exercise gravity expression
  "Against which gravity does it swing in the end, in g and `(((expt D 2) y) t)`?"
  (key (+ 'g (((expt D 2) y) 't)))
  (points 2))

(exercise why reason "Why may terms of the Lagrangian that depend on t alone be left out?")
