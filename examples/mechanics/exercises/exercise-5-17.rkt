#lang mechanics
;; Exercise 5.17 (SICM 5.5): Lagrange's equations of the extended Lagrangian
;; Checked: that they are those of L, and that of the time the rate of the energy
;; How: residuals along any path, with any function for the time

(define ((L m V) (up t q v)) (- (* 1/2 m (square v)) (V t q)))
(define ((extended L) (up tau (up q t) (up v v_t)))
  (* (L (up t q (/ v v_t))) v_t))
(define L-here (L 'm (literal-function 'V (-> (X Real Real) Real))))

;; The path q(t) with t = f(τ), and its residuals in L_e.
(define-values (q f) (values (literal-function 'q) (literal-function 'f)))
(define path (up (compose q f) f))
(define residuals (((Lagrange-equations (extended L-here)) path) 'tau))

;; a. That of q is the one of L at the time f(τ), times Df.
(define old-residual (((Lagrange-equations L-here) q) (f 'tau)))
(define right (verify-equal (ref residuals 0) (* ((D f) 'tau) old-residual)))
right

;; b. That of t is −DE − ∂₀L, times Df: the energy changes as L depends on the time.
(define E (compose (Lagrangian->energy L-here) (Gamma q)))
(define rate (+ (D E) (compose ((partial 0) L-here) (Gamma q))))
(define of-time (verify-equal (ref residuals 1) (* -1 ((D f) 'tau) (rate (f 'tau)))))
of-time

;; The slip: that the energy is conserved, as L_e does not depend on τ.
(define slip (verify-equal (ref residuals 1) (* -1 ((D f) 'tau) ((D E) (f 'tau)))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the equations of L and the rate of the energy"
    (check-pred proved? right)
    (check-pred proved? of-time))
  (test-case "the energy of L changes"
    (check-pred refuted? slip)))
