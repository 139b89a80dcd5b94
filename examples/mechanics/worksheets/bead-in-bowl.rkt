#lang mechanics/worksheet
;; SICM 1.6 and 3.2: a bead in a bowl, with answers as they stand on paper.

(title "A bead in a bowl")

(text "A bead of mass m slides without friction on the inside of a bowl, along the parabola "
      "`(= z (* a (square r)))`; gravity is g. Answer as on paper, with texts: "
      "\"m r'' + k r = 0\" is one.")

(define (L (up t r rdot))
  (- (* 1/2 'm (+ 1 (* 4 (square 'a) (square r))) (square rdot))
     (* 'm 'g 'a (square r))))

(exercise L-bead Lagrangian "A Lagrangian of the bead."
  (coordinates r) (key L) (points 2)
  (slip (lambda ((up t r rdot)) (- (* 1/2 'm (square rdot)) (* 'm 'g 'a (square r))))
        "The bead moves upwards, too: with which velocity?"))

(exercise motion equations "The equation of motion."
  (coordinates r) (of L) (points 3)
  (hint "How does the momentum depend on r?"))

(exercise swings expression "The period of small swings for g = 9.81 m/s², as it depends on a."
  (key (/ (* 2 pi) (sqrt (* 2 9.81 'a)))) (within 1/100) (points 2)
  (hint "Near the bottom `(square r)` is as good as 0."))

(exercise bracket phase-function
  "The Poisson bracket {r², p²}, with p for the momentum that belongs to r."
  (coordinates r) (key (lambda ((up t r p)) (* 4 r p))) (points 1))
