#lang mechanics
;; From Newton's equations to Lagrange's, for any two particles in space whose positions
;; are functions of the time and two coordinates, and for any forces on them.
;;
;; Each line of the derivation is an identity between functions of time, along any path.

;; r(t, q) = (r_1, r_2), F(t, r, v), q(t) = (a, b)
(define (position name)
  (literal-function name (-> (X Real (UP Real Real)) (UP Real Real Real))))
(define r (up (position 'r_1) (position 'r_2)))
(define two-in-space '(UP (UP Real Real Real) (UP Real Real Real)))
(define F (literal-function 'F (-> (X Real two-in-space two-in-space) two-in-space)))
(define masses (list 'm_1 'm_2))
(define q (up (literal-function 'a) (literal-function 'b)))

;; Functions of the local tuple: positions, their slopes ∂r/∂q, and velocities.
(define (positions local) (r (time local) (coordinate local)))
(define (slopes local) (((partial 1) positions) local))
(define velocities (particle-velocities r))
(define (along f) (compose f (Gamma q)))
(define (m x) (up (* 'm_1 (ref x 0)) (* 'm_2 (ref x 1))))

;; Velocities are what positions change by,
(verify-equal (D (along positions)) (along velocities))
;; and depend on those of the coordinates through ∂v/∂q̇ = ∂r/∂q.
(verify-equal (along ((partial 2) velocities)) (along slopes))
;; The slopes themselves change by d/dt ∂r/∂q = ∂v/∂q.
(verify-equal (D (along slopes)) (along ((partial 1) velocities)))

;; Hence m a·∂r/∂q = d/dt (m v·∂r/∂q) − m v·∂v/∂q, where v·∂r/∂q is v·∂v/∂q̇.
(define ((work-of x) t)                 ; Σ x·∂r/∂q_j, x a function of time like positions
  (define s ((along slopes) t))
  (down (dot-product (x t) (ref s 0)) (dot-product (x t) (ref s 1))))
(define (momenta t) (m ((along velocities) t)))
(define (half-square-slope i)           ; Σ m v·∂v/∂q_j, or of ∂v/∂q̇_j
  (lambda (t)
    (define s ((along ((partial i) velocities)) t))
    (down (dot-product (momenta t) (ref s 0)) (dot-product (momenta t) (ref s 1)))))
(verify-equal (work-of (D momenta))
              (- (D (half-square-slope 2)) (half-square-slope 1)))

;; These are derivatives of the kinetic energy T = Σ ½ m v².
(define T (kinetic-energy masses r))
(verify-equal (half-square-slope 1) (along ((partial 1) T)))
(verify-equal (half-square-slope 2) (along ((partial 2) T)))

;; So Newton's equations, multiplied by virtual displacements, are Lagrange's.
(define no-force (lambda (t r v) 0))
(verify-equal ((d-Alembert-equations masses r no-force) q) ((Lagrange-equations T) q))
(verify-equal ((d-Alembert-equations masses r F) q)
              ((Lagrange-equations T #:force (generalized-force r F)) q))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-identity a b)
    (begin (check-true (proved? (verify-equal a b)))
           (check-true (refuted? (verify-equal a (* 2 b))))))
  (test-case "each line is an identity, and none is with a factor"
    (check-identity (D (along positions)) (along velocities))
    (check-identity (along ((partial 2) velocities)) (along slopes))
    (check-identity (D (along slopes)) (along ((partial 1) velocities)))
    (check-identity (work-of (D momenta)) (- (D (half-square-slope 2)) (half-square-slope 1)))
    (check-identity (half-square-slope 1) (along ((partial 1) T)))
    (check-identity (half-square-slope 2) (along ((partial 2) T)))
    (check-identity ((d-Alembert-equations masses r no-force) q) ((Lagrange-equations T) q))
    (check-identity ((d-Alembert-equations masses r F) q)
                    ((Lagrange-equations T #:force (generalized-force r F)) q)))
  (test-case "the sign of a force matters"
    (check-true (refuted? (verify-equal ((d-Alembert-equations masses r F) q)
                                        ((Lagrange-equations T #:force (generalized-force r (- F)))
                                         q))))))
