#lang mechanics
;; Exercise 5.16 (SICM 5.5): the extended Lagrangian is homogeneous
;; Checked: that it is of degree one in the velocities
;; How: Euler's theorem and scaling, for any Lagrangian

;; L_e(τ; q, t; v, v_t) = L(t, q, v/v_t) v_t

(define L (literal-function 'L (Lagrangian 1)))
(define ((extended L) (up tau (up q t) (up v v_t)))
  (* (L (up t q (/ v v_t))) v_t))
(define L_e (extended L))
(define local (up 'tau (up 'q 't) (up 'v 'v_t)))

;; Euler: ∂₂L_e · (v, v_t) = L_e.
(define right (verify-equal (* (((partial 2) L_e) local) (velocity local)) (L_e local)))
right
(define (scaled s) (up (time s) (coordinate s) (* 'lambda (velocity s))))
(define scaling (verify-equal (L_e (scaled local)) (* 'lambda (L_e local))))
scaling

;; So the energy of L_e is 0: it has no Legendre transform, its momenta are not independent.
(define energy (verify-equal ((Lagrangian->energy L_e) local) 0))
energy
(define Hessian (verify-equal (determinant (((partial 2) ((partial 2) L_e)) local)) 0))
Hessian

;; The slip: without the factor v_t.
(define (slip-L s) ((literal-function 'L (Lagrangian 1))
                    (up (ref s 1 1) (ref s 1 0) (/ (ref s 2 0) (ref s 2 1)))))
(define slip (verify-equal (* (((partial 2) slip-L) local) (velocity local)) (slip-L local)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "of degree one, with an energy of 0"
    (for ([v (list right scaling energy Hessian)]) (check-pred proved? v)))
  (test-case "without the factor it is of degree 0"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (* (((partial 2) slip-L) local) (velocity local)) 0))))
