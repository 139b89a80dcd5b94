#lang mechanics
;; Exercise 1.19 (SICM 1.6.2): a linkage of two bars
;; Checked: the Lagrangian in the hinge's place and the bars' angles
;; How: against three falling particles, with the bars as coordinates

;; Two bars without mass are joined by a hinge of mass m_2; masses m_1 and m_3 are at their
;; other ends.  The linkage moves in a vertical plane.  Find its Lagrangian.

(define ((L-falling masses g) (up t places velocities))
  (for/sum ([m masses] [q places] [v velocities])
    (- (* 1/2 m (square v)) (* m g (ref q 1)))))

;; The angles are those from straight down.
(define ((linkage l_1 l_2) (up t (up x y theta phi) v))
  (define hinge (up x y))
  (define (end l angle) (+ hinge (* l (up (sin angle) (- (cos angle))))))
  (up (end l_1 theta) hinge (end l_2 phi)))

(define L (compose (L-falling (list 'm_1 'm_2 'm_3) 'g) (F->C (linkage 'l_1 'l_2))))

;; In an attempt each end moves with the hinge and turns about it.  In one with a slip the
;; turning has energy of its own, but none together with the motion of the hinge.
(define ((by-energies coupling) (up t (up x y theta phi) (up vx vy alpha beta)))
  (define (end m l angle rate)
    (- (* 1/2 m (+ (square vx) (square vy) (square (* l rate))
                   (* 2 coupling l rate (+ (* vx (cos angle)) (* vy (sin angle))))))
       (* m 'g (- y (* l (cos angle))))))
  (+ (end 'm_1 'l_1 theta alpha)
     (end 'm_3 'l_2 phi beta)
     (- (* 1/2 'm_2 (+ (square vx) (square vy))) (* 'm_2 'g y))))

(define local (up 't (up 'x 'y 'theta 'phi) (up 'vx 'vy 'alpha 'beta)))
(define right (verify-equal (L local) ((by-energies 1) local)))
(define wrong (verify-equal (L local) ((by-energies 0) local)))
right
wrong

;; The hinge's velocity is a factor of what is left over: with it at rest the slip is none.
(prove-zero (substitute (substitute (verdict-residual wrong) 'vx 0) 'vy 0))

(module+ test
  (require rackunit)
  (test-case "the Lagrangian by energies is that by coordinates"
    (check-pred proved? right))
  (test-case "the slip shows where the hinge moves"
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (substitute (substitute (verdict-residual wrong) 'vx 0)
                                                'vy 0)))))
