#lang mechanics
;; Exercise 2.8 (SICM 2.6): the angular momentum of a rotation
;; Checked: its components by the inertia tensor, L_j = Σ I_jk ω_k
;; How: against the sum of ξ × m (ω × ξ) over the points of a body

;; The points of a body that turns with ω about its centre of mass move at ω × ξ.  Is their
;; angular momentum the tensor of the body times ω?

(define omega (up 'omega^x 'omega^y 'omega^z))
(define points (list (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define masses '(m_1 m_2))

(define (sum-over f) (apply + (map f masses points)))
(define L (sum-over (lambda (m xi) (cross-product xi (* m (cross-product omega xi))))))

;; An attempt at the tensor, from ξ × (ω × ξ) = ω ξ² − ξ (ξ · ω).
(define ((of-point mix) m (up x y z))
  (* m (matrix-by-rows (list (+ (square y) (square z)) (* mix x y) (* mix x z))
                       (list (* mix y x) (+ (square z) (square x)) (* mix y z))
                       (list (* mix z x) (* mix z y) (+ (square x) (square y))))))
(define (tensor mix) (sum-over (of-point mix)))
(define right (verify-equal (* (tensor -1) omega) L))
right

;; It is the tensor of the kinetic energy.
(define same (verify-equal (tensor -1) (inertia-tensor masses points)))
same

;; A slip: products of inertia with the other sign.
(define slip (verify-equal (* (tensor +1) omega) L))
(verdict-status slip)

;; Its residual is twice the products; it hides where the axes are principal ones.
(ref (verdict-residual slip) 2)
(define principal (impose (verdict-residual slip) '((= x_1 0) (= y_1 0) (= x_2 0) (= z_2 0))))
principal

(module+ test
  (require rackunit)
  (test-case "the components are right, and the tensor is the energy's"
    (check-pred proved? right)
    (check-pred proved? same))
  (test-case "the slip is seen, but not on principal axes"
    (check-pred refuted? slip)
    (check-pred proved? (prove-zero principal))))
