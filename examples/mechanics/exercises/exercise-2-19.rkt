#lang mechanics
;; Exercise 2.19 (SICM 2.12): quaternions and rotations one after the other
;; Checked: the product of two quaternions, and ω of one that changes
;; How: against products and derivatives of matrices

;; Show that the product of quaternions does what the product of rotation matrices does, and find
;; the angular velocity of a body from its quaternion and the rate of change of that.

(define p (quaternion 'p_0 'p_1 'p_2 'p_3))
(define q (quaternion 'q_0 'q_1 'q_2 'q_3))
(define M quaternion->rotation-matrix)

;; An attempt at the product, by parts.
(define attempt
  (quaternion (- (* 'p_0 'q_0) (* 'p_1 'q_1) (* 'p_2 'q_2) (* 'p_3 'q_3))
              (+ (* 'p_0 'q_1) (* 'p_1 'q_0) (* 'p_2 'q_3) (* -1 'p_3 'q_2))
              (+ (* 'p_0 'q_2) (* 'p_2 'q_0) (* 'p_3 'q_1) (* -1 'p_1 'q_3))
              (+ (* 'p_0 'q_3) (* 'p_3 'q_0) (* 'p_1 'q_2) (* -1 'p_2 'q_1))))
(define product (verify-equal (* p q) attempt))
(define right (verify-equal (M attempt) (* (M p) (M q))))
product
right

;; A slip: the first rotation written first, as one reads.
(define wrong (verify-equal (M (* q p)) (* (M p) (M q))))
(verdict-status wrong)

;; It is no slip for rotations about one axis, nor for half turns about axes at right angles.
(define-values (half-x half-y) (values (quaternion 0 1 0 0) (quaternion 0 0 1 0)))
(define half-turns (verify-equal (M (* half-x half-y)) (M (* half-y half-x))))
half-turns

;; The angular velocity on the body, 2 q* q̇, for a q of length 1.
(define (unit t) (q:make-unit (make-quaternion (for/list ([f four]) (f t)))))
(define four (map literal-function '(q_0 q_1 q_2 q_3)))
(define path (lambda (t) (quaternion->vector (unit t))))
(define omega
  (quaternion->3vector (* 2 (q:conjugate (unit 't)) ((D unit) 't))))
(define found (((M-of-q->omega-body-of-t (compose M make-quaternion)) path) 't))
(define rate (verify-equal (column-matrix->up found) omega))
rate

(module+ test
  (require rackunit)
  (test-case "the product, and its matrix"
    (check-pred proved? product)
    (check-pred proved? right)
    (check-pred proved? rate))
  (test-case "the order matters, except where it does not"
    (check-pred refuted? wrong)
    (check-pred proved? half-turns)
    (check-false (= (* half-x half-y) (* half-y half-x)))))
