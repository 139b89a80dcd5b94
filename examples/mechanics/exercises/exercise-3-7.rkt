#lang mechanics
;; Exercise 3.7 (SICM 3.1.1): an ellipsoidal bowl
;; Checked: the Hamiltonian of a particle in a bowl z = a x² + b y², and what it says at once
;; How: against the Legendre transform; conserved quantities and small oscillations

(define ((L m g a b) (up t (up x y) (up vx vy)))
  (define vz (* 2 (+ (* a x vx) (* b y vy))))
  (- (* 1/2 m (+ (square vx) (square vy) (square vz)))
     (* m g (+ (* a (square x)) (* b (square y))))))
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define of-L (Lagrangian->Hamiltonian (L 'm 'g 'a 'b)))

;; With the slopes u = (2 a x, 2 b y) of the bowl, p = m (v + u (u · v)); so
;; u · p = m (1 + u²) u · v, and v follows.
(define ((H m g a b) (up t (up x y) (down p_x p_y)))
  (define-values (u_x u_y) (values (* 2 a x) (* 2 b y)))
  (+ (/ (- (+ (square p_x) (square p_y))
           (/ (square (+ (* u_x p_x) (* u_y p_y))) (+ 1 (square u_x) (square u_y))))
        (* 2 m))
     (* m g (+ (* a (square x)) (* b (square y))))))
(define bowl (H 'm 'g 'a 'b))
(define right (verify-equal (bowl state) (of-L state)))
right

;; A slip: the energy of a plane, with the height of the bowl.
(define (height-alone s) (bowl (up (time s) (coordinate s) (down 0 0))))
(define (H-flat s) (+ (/ (square (momentum s)) (* 2 'm)) (height-alone s)))
(define slip (verify-equal (H-flat state) (of-L state)))
(verdict-status slip)

;; It is right at the bottom only: the small oscillations are those of the bowl.
(small-oscillation-frequencies bowl (up 0 0))
(small-oscillation-frequencies H-flat (up 0 0))

;; The time does not occur: the energy is conserved.  The angular momentum about the vertical is
;; in a round bowl.
(define (L_z (up t (up x y) (down p_x p_y))) (- (* x p_y) (* y p_x)))
(define energy (verify-conserved bowl bowl state))
(define angular (verify-conserved bowl L_z state))
energy
(verdict-conditions angular)

;; Both planes of symmetry are kept: who starts along an axis stays there.
(define along
  (prove-zero (ref ((Hamiltonian->state-derivative bowl) (up 't (up 'x 0) (down 'p_x 0))) 2 1)))
along

(module+ test
  (require rackunit)
  (test-case "the Hamiltonian"
    (for ([v (list right energy along)]) (check-pred proved? v)))
  (test-case "on a plane the kinetic energy is greater by what the slope takes"
    (check-pred refuted? slip)
    (check-pred proved?
                (prove-zero (impose (verdict-residual slip) '((= x 0) (= y 0))))))
  (test-case "the angular momentum is conserved in a round bowl"
    (check-pred refuted? angular)
    (check-pred proved? (verify-again angular '(= a b)))))
