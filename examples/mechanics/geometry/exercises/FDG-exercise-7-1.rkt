#lang mechanics
;; Exercise 7.1 (FDG 7): Hamilton's equations as a vector field
;; Checked: rates of a particle on a sphere, and the series of its motion by Lie derivatives
;; How: against the state derivative, and term by term

(require mechanics/geometry)
(define (L (up t (up theta phi) (up thetadot phidot)))
  (* 1/2 (+ (square thetadot) (square (* (sin theta) phidot)))))
(define rates
  ((Hamiltonian->state-derivative (Lagrangian->Hamiltonian L))
   (up 't (up 'theta 'phi) (down 'p_theta 'p_phi))))
rates

;; States as points of a manifold of five dimensions, and the rates as a field there
(define states (coordinate-system-at 'rectangular 'origin (make-manifold R^n 5)))
(define-coordinates (up t (up theta phi) (down p_theta p_phi)) states)
(define v
  (+ d/dt (* p_theta d/dtheta) (* (/ p_phi (square (sin theta))) d/dphi)
     (* (/ (* (square p_phi) (cos theta)) (cube (sin theta))) d/dp_theta)))
(define state ((point states) (up 't 'theta 'phi 'p_theta 'p_phi)))
(define (rate f) ((v f) state))
(define same-rates
  (verify-equal rates
                (up (rate t) (up (rate theta) (rate phi)) (down (rate p_theta) (rate p_phi)))))
same-rates

;; θ after the time s, as a series
(define series (((exp (* 's (Lie-derivative v))) theta) state))
(define terms (list->up (series:head series 3)))
terms

;; The angular momentum stays, and so does its part along the axis.
(define momentum (+ (square p_theta) (square (/ p_phi (sin theta)))))
(define kept (verify-equal ((Lie-derivative v) momentum) 0))
kept

;; The slip: p_θ taken to stay as well, as if θ were not in the Hamiltonian
(define wrong (verify-equal ((Lie-derivative v) p_theta) 0))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "the field has the rates of the state derivative"
    (check-pred proved? same-rates)
    (check-pred proved?
                (verify-equal rates
                              (up 1 (up 'p_theta (/ 'p_phi (square (sin 'theta))))
                                  (down (/ (* (square 'p_phi) (cos 'theta)) (cube (sin 'theta)))
                                        0)))))
  (test-case "the series"
    (define acceleration (/ (* (square 'p_phi) (cos 'theta)) (cube (sin 'theta))))
    (check-pred proved?
                (verify-equal terms (up 'theta (* 's 'p_theta) (* 1/2 (square 's) acceleration)))))
  (test-case "what stays"
    (check-pred proved? kept)
    (check-pred refuted? wrong)))
