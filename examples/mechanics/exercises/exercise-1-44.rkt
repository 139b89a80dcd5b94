#lang mechanics
;; Exercise 1.44 (SICM 1.12): the double pendulum
;; Checked: the Lagrangian in two angles, and a motion
;; How: against two falling masses; by the energy; by a second motion that starts beside it

;; A pendulum of length l_1 and mass m_1 has another one, l_2 and m_2, hanging from its bob.  Find
;; a Lagrangian, and follow the motion from rest, the upper bar level and the lower one straight
;; up.  (The runs of 50 s and their picture are in examples/mechanics/figures/exercise-1-44.rkt.)

(define ((L-falling m_1 m_2 g) (up t (up q_1 q_2) (up v_1 v_2)))
  (- (+ (* 1/2 m_1 (square v_1)) (* 1/2 m_2 (square v_2)))
     (+ (* m_1 g (ref q_1 1)) (* m_2 g (ref q_2 1)))))
(define ((bobs l_1 l_2) (up t (up theta phi) v))
  (define (bar l angle) (up (* l (sin angle)) (* -1 l (cos angle))))
  (define upper (bar l_1 theta))
  (up upper (+ upper (bar l_2 phi))))
(define (L-double m_1 m_2 l_1 l_2 g)
  (compose (L-falling m_1 m_2 g) (F->C (bobs l_1 l_2))))

;; An attempt by hand.  In the slip it is the sum of the angles that matters, not the difference.
(define ((by-hand m_1 m_2 l_1 l_2 g combine) (up t (up theta phi) (up alpha beta)))
  (+ (* 1/2 (+ m_1 m_2) (square (* l_1 alpha)))
     (* 1/2 m_2 (square (* l_2 beta)))
     (* m_2 l_1 l_2 alpha beta (cos (combine theta phi)))
     (* (+ m_1 m_2) g l_1 (cos theta))
     (* m_2 g l_2 (cos phi))))

(define local (up 't (up 'theta 'phi) (up 'alpha 'beta)))
(define (verdict combine)
  (verify-equal ((L-double 'm_1 'm_2 'l_1 'l_2 'g) local)
                ((by-hand 'm_1 'm_2 'l_1 'l_2 'g combine) local)))
(define right (verdict -))
(define wrong (verdict +))
right
wrong

;; The motion in numbers.  Does the energy stay what it was?
(define L (by-hand 1. 3. 1. 0.9 9.8 -))
(define (motion theta)
  (evolve-trajectory (Lagrangian->state-derivative L)
                     (up 0. (up theta :pi) (up 0. 0.)) 5. #:tolerance 1e-12))
(define swing (motion :pi/2))
(define energy (Lagrangian->energy L))
(define (drift t) (abs (- (energy (swing t)) (energy (swing 0.)))))
(for/and ([t '(1. 2. 3. 4. 5.)]) (< (drift t) 1e-8))

;; A motion that starts 10⁻⁸ aside does not stay as near as that.
(define beside (motion (+ :pi/2 1e-8)))
(define (apart t) (sqrt (square (- (coordinate (swing t)) (coordinate (beside t))))))
(> (apart 5.) (* 10 (apart 0.)))

(module+ test
  (require rackunit)
  (test-case "the Lagrangian by hand; the slip is right where an angle is 0"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (substitute (verdict-residual wrong) 'phi 0))))
  (test-case "the motion after 1 and 5 seconds"
    (for ([x (coordinate (swing 1.))] [expected '(.0910630038849611 -1.66626245247204)])
      (check-= x expected 1e-9))
    (for ([x (coordinate (swing 5.))] [expected '(6.82360398985888 8.60368993913788)])
      (check-= x expected 1e-7)))
  (test-case "energy stays, neighbours part"
    (check-true (for/and ([t '(1. 2. 3. 4. 5.)]) (< (drift t) 1e-8)))
    (check-true (> (apart 5.) (* 10 (apart 0.))))))
