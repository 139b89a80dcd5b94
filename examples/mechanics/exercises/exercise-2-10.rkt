#lang mechanics
;; Exercise 2.10 (SICM 2.8): a rigid body in a uniform field
;; Checked: that it turns like a free one while its centre goes along a parabola
;; How: the potential energy of its points, Lagrange's equations, and a path

;; Each point of the body is pulled by −m g.  Show that its rotation knows nothing of that.

;; Three points, at ξ from the centre of mass; the third is where it has to be for that.
(define masses '(m_1 m_2 m_3))
(define-values (xi-1 xi-2) (values (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define xi-3 (/ (+ (* 'm_1 xi-1) (* 'm_2 xi-2)) (* -1 'm_3)))
(define total (apply + masses))

;; The height of each point, in the orientation q and with the centre at X.
(define ((potential points) X q)
  (define (height xi) (+ (ref X 2) (ref (* (Euler->M q) xi) 2)))
  (apply + (map (lambda (m xi) (* m 'g (height xi))) masses points)))

(define q (up 'theta 'phi 'psi))
(define X (up 'X 'Y 'Z))
(define right
  (verify-equal ((potential (list xi-1 xi-2 xi-3)) X q) (* total 'g (ref X 2))))
right

;; So the Lagrangian falls apart: ½ M V² − M g Z, and that of a free body.
(define T-free (T-body-Euler 'A 'B 'C))
(define (L (up t (up X q) (up V qdot)))
  (+ (- (* 1/2 'M (square V)) (* 'M 'g (ref X 2))) (T-free (up t q qdot))))
(define angles (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))
(define (parabola t)
  (up (* 'u t) (* 'v t) (- (+ 'h (* 'w t)) (* 1/2 'g (square t)))))
(define (path t) (up (parabola t) (angles t)))
(define residual (((Lagrange-equations L) path) 't))
(define falling (prove-zero (ref residual 0)))
(define turning (verify-equal (ref residual 1) (((Lagrange-equations T-free) angles) 't)))
falling
turning

;; A slip: a point of the body that is not its centre of mass, as its first one.
(define from-first (list (- xi-1 xi-1) (- xi-2 xi-1) (- xi-3 xi-1)))
(define slip (verify-equal ((potential from-first) X q) (* total 'g (ref X 2))))
(verdict-status slip)

;; The rest turns it: the height of the centre of mass above that point.
(define torque
  (verify-equal (verdict-residual slip) (* -1 total 'g (ref (* (Euler->M q) xi-1) 2))))
torque

(module+ test
  (require rackunit)
  (test-case "centre of mass and rotation part"
    (for ([v (list right falling turning)]) (check-pred proved? v)))
  (test-case "about another point there is a torque"
    (check-pred refuted? slip)
    (check-pred proved? torque)))
