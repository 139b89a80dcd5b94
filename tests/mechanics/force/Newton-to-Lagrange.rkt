#lang racket/base
;; From Newton's equations to Lagrange's, for any positions and forces: each line of the
;; derivation is an identity, and each is seen to fail when a term is changed.

(require mechanics
         "../support/checks.rkt" "../support/forces.rkt")

(define q-1 (literal-function 'q))
(define q-2 (up (literal-function 'a) (literal-function 'b)))
(define state-1 (up 't 'q 'v))
(define state-2 (up 't (up 'a 'b) (up 'v_a 'v_b)))

(define (verdict-of x) (verdict-status (prove-zero x)))

;; name, positions, masses, force, path, local tuple
(define cases
  (list (list "one particle, one coordinate" position-1 'm force-on-one q-1 state-1)
        (list "one particle, two coordinates" position-2 'm force-on-one q-2 state-2)
        (list "two particles, one coordinate" positions-1 '(m_1 m_2) force-on-two q-1 state-1)
        (list "two particles, two coordinates" positions-2 '(m_1 m_2) force-on-two q-2 state-2)))

(define-syntax-rule (for-each-case (r masses F q state) body ...)
  (for ([c cases])
    (define-values (name r masses F q state) (apply values c))
    (with-check-info (['case name]) body ...)))

(define (along f q) (compose f (Gamma q)))
(define ((of-local r) local) (r (time local) (coordinate local)))
(define ((slope r) local) (((partial 1) (of-local r)) local))

(test-case "velocities are ∂₀r + ∂₁r q̇, and the rate of change along a path"
  (for-each-case (r masses F q state)
    (define v (particle-velocities r))
    (check-eq? (verdict-of (- (v state) (+ (((partial 0) r) (time state) (coordinate state))
                                           (* ((slope r) state) (velocity state)))))
               'proved)
    (check-eq? (verdict-of (- (along v q) (D (along (of-local r) q)))) 'proved)
    (check-eq? (verdict-of (- (along v q) (* 2 (D (along (of-local r) q))))) 'refuted)))

(test-case "∂v/∂q̇ = ∂r/∂q"
  (for-each-case (r masses F q state)
    (define v (particle-velocities r))
    (check-eq? (verdict-of (- (((partial 2) v) state) ((slope r) state))) 'proved)
    (check-eq? (verdict-of (+ (((partial 2) v) state) ((slope r) state))) 'refuted)))

(test-case "d/dt ∂r/∂q = ∂v/∂q"
  (for-each-case (r masses F q state)
    (define v (particle-velocities r))
    (check-eq? (verdict-of (- (D (along (slope r) q)) (along ((partial 1) v) q))) 'proved)
    (check-eq? (verdict-of (- (D (along (slope r) q)) (* 2 (along ((partial 1) v) q)))) 'refuted)))

(test-case "Σ m v̇·∂r/∂q = d/dt ∂T/∂q̇ − ∂T/∂q"
  (define (no-force t r v) 0)
  (for-each-case (r masses F q state)
    (define T (kinetic-energy masses r))
    (define newton ((d-Alembert-equations masses r no-force) q))
    (check-eq? (verdict-of (- newton ((Lagrange-equations T) q))) 'proved)
    (check-eq? (verdict-of (- newton (D (along ((partial 2) T) q)))) 'refuted)))

(test-case "Σ (m v̇ − F)·∂r/∂q is Lagrange's residual with the generalized force"
  (for-each-case (r masses F q state)
    (define T (kinetic-energy masses r))
    (define newton ((d-Alembert-equations masses r F) q))
    (define Q (generalized-force r F))
    (check-eq? (verdict-of (- newton ((Lagrange-equations T #:force Q) q))) 'proved)
    (check-eq? (verdict-of (- newton ((Lagrange-equations T #:force (* -1 Q)) q))) 'refuted)))

(test-case "forces of a potential become part of the Lagrangian"
  (define V (literal-function 'V (-> (X Real (UP Real Real Real)) Real)))
  (define ((V-of r) local) (V (time local) ((of-local r) local)))
  (for ([r (list position-1 position-2)] [q (list q-1 q-2)])
    (check-eq? (verdict-of (- ((d-Alembert-equations 'm r (potential->force V)) q)
                              ((Lagrange-equations (- (kinetic-energy 'm r) (V-of r))) q)))
               'proved)))

(test-case "the kinetic energy is that of free particles in other coordinates"
  (define ((free m) local) (* 1/2 m (square (velocity local))))
  (check-eq? (verdict-of (- ((kinetic-energy 'm position-2) state-2)
                            ((compose (free 'm) (F->C (of-local position-2))) state-2)))
             'proved))
