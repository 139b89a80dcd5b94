#lang mechanics
;; Exercise 3.6 (SICM 3.1.1): on a helical track
;; Checked: the Hamiltonian of a mass that slides down a screw, what is kept, and the motion
;; How: against the Legendre transform; Hamilton's equations along proposed paths

;; A cylinder M, R turns freely on a vertical axis; on it a mass m slides along a track that goes
;; round by β for each metre down.  Coordinates: the angle θ of the cylinder, and the depth z.

(define ((L M m R beta g) (up t (up theta z) (up thetadot zdot)))
  (+ (* 1/4 M (square R) (square thetadot))
     (* 1/2 m (+ (square (* R (+ thetadot (* beta zdot)))) (square zdot)))
     (* m g z)))
(define state (up 't (up 'theta 'z) (down 'p_theta 'p_z)))

;; The moments of inertia of the cylinder and of the mass about the axis:
(define-values (C I) (values (* 1/2 'M (square 'R)) (* 'm (square 'R))))

;; An attempt: p_z − β p_θ' moves the mass down the track, with p_θ' the part of the mass.
(define ((H C I m beta g) (up t (up theta z) (down p_theta p_z)))
  (define inertia (+ m (/ (* (square beta) C I) (+ C I))))
  (define down (- p_z (/ (* beta I p_theta) (+ C I))))
  (- (+ (/ (square p_theta) (* 2 (+ C I))) (/ (square down) (* 2 inertia))) (* m g z)))
(define right
  (verify-equal ((H C I 'm 'beta 'g) state)
                ((Lagrangian->Hamiltonian (L 'M 'm 'R 'beta 'g)) state)))
right

(define track (H 'C 'I 'm 'beta 'g))
((Hamiltonian->state-derivative track) state)

;; The angle does not occur: the angular momentum is conserved, and so is H.
(conserved-momenta track state)
(define energy (verify-conserved track track state))
energy

;; Released at rest, p_θ = 0; the mass goes down as if it fell on a plane.
(define (falling a)
  (define (z t) (* 1/2 a (square t)))
  (define (theta t) (* -1 (/ (* 'beta 'I) (+ 'C 'I)) (z t)))
  (define inertia (+ 'm (/ (* (square 'beta) 'C 'I) (+ 'C 'I))))
  (verify-Hamiltonian-solution track (up theta z)
                               (down (lambda (t) 0) (lambda (t) (* inertia a t)))))
(define motion
  (falling (/ (* 'm 'g (+ 'C 'I)) (+ (* 'm (+ 'C 'I)) (* (square 'beta) 'C 'I)))))
motion

;; A slip: the track stays where it is, so that the mass is m (1 + β²R²), here m + β² I.
(define slip (falling (/ (* 'm 'g) (+ 'm (* (square 'beta) 'I)))))
(verdict-status slip)
(verdict-conditions slip)

(module+ test
  (require rackunit)
  (test-case "the Hamiltonian, what it keeps, and the motion"
    (for ([v (list right energy motion)]) (check-pred proved? v))
    (check-equal? (conserved-momenta track state) (list (up 'theta 'p_theta))))
  (test-case "a track that does not turn is another system, unless nothing moves it"
    (check-pred refuted? slip)
    (check-not-false (member '(= beta 0) (map expression (verdict-conditions slip))))))
