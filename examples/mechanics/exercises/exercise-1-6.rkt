#lang mechanics
;; Exercise 1.6 (SICM 1.4): a path that cannot be
;; Checked: what minimizing gives for a free particle with fixed velocities at both ends
;; How: the least action of polynomial paths of growing degree, and Lagrange's equations

;; A free particle goes from 0 to 1 in a unit of time, but is to be at rest at both ends.
;; No motion does that.  What does the minimization give?

(define ((L-free m) (up t x v)) (* 1/2 m (square v)))

;; All polynomials with the right ends and velocities: a cubic, and multiples of t² (1 − t)².
(define ((path coefficients) t)
  (+ (* (square t) (- 3 (* 2 t)))
     (* (square t) (square (- 1 t))
        (for/sum ([c coefficients] [k (in-naturals)])
          (* c (expt (- t 1/2) k))))))

(define (action coefficients)
  (Lagrangian-action (L-free 1) (path coefficients) 0 1))

(define (least-action n)
  (action (multidimensional-minimize action (for/list ([k n]) 0.))))

;; Attempt: the least action is that of the cubic, 3/5.  More freedom refutes it: it comes
;; down towards 1/2, the action of uniform motion, which the ends forbid.
(action '())
(define actions (for/list ([n '(2 4)]) (least-action n)))
(for/list ([a actions]) (/ (round (* 1e4 a)) 1e4))

;; None of these paths is a motion, and Lagrange's equations say so.
(define verdict (verify-solution (L-free 'm) (path '(c))))
verdict

(module+ test
  (require rackunit)
  (test-case "the least action goes down, but not below that of uniform motion"
    (check-= (action '()) 3/5 1e-12)
    (check-true (apply > 3/5 actions))
    (check-true (> (apply min actions) 1/2))
    (for ([a actions] [expected '(15/28 14/27)]) (check-= a expected 1e-6)))
  (test-case "no polynomial with such ends is a motion"
    (check-pred refuted? verdict)))
