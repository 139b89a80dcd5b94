#lang mechanics
;; Exercise 3.8 (SICM 3.4): the sleeping top
;; Checked: how fast an upright top must turn not to fall
;; How: by the second derivative of its effective potential, and by motions on both sides

(require mechanics/book)

(define H (Lagrangian->Hamiltonian (L-axisymmetric-top 'A 'C 'gMR)))

;; Upright, p_φ = p_ψ = p.  Then θ moves in an effective potential that has no pole at θ = 0:
(define (U theta)
  (+ (/ (square 'p) (* 2 'C))
     (/ (* (square 'p) (square (tan (/ theta 2)))) (* 2 'A))
     (* 'gMR (cos theta))))
(define potential
  (verify-equal (H (up 't (up 'theta 'phi 'psi) (down 0 'p 'p))) (U 'theta)))
potential

(define right (verify-equal (((expt D 2) U) 0) (- (/ (square 'p) (* 4 'A)) 'gMR)))
right

;; So p² > 4 A gMR: the library's question about a system with one coordinate says the same.
(define (L-upright (up t theta thetadot)) (- (* 1/2 'A (square thetadot)) (U theta)))
(define stability (assuming ('(> A 0)) (equilibrium-stability L-upright 0)))
stability

;; The slip: tan²(θ/2) is about θ²/2.
(define slip (verify-equal (((expt D 2) U) 0) (- (/ (square 'p) (* 2 'A)) 'gMR)))
(verdict-residual slip)

;; By motion: A = 6.96e-4, C = 1.32e-4, gMR = 0.112, from an angle of 0.01.
(define (system) (Hamiltonian->state-derivative
                  (Lagrangian->Hamiltonian (L-axisymmetric-top 6.96e-4 1.32e-4 .112))))
(define (farthest p)
  (define motion
    (evolve-trajectory (system) (up 0 (up 0.01 0.0 0.0) (down 0.0 p (* p 1.0))) 2))
  (for/fold ([most 0]) ([i 401]) (max most (ref (coordinate (motion (/ i 200.0))) 0))))
(define critical (sqrt (* 4 6.96e-4 .112)))
(list critical (farthest (* 1.1 critical)) (farthest (* 0.9 critical)))

(module+ test
  (require rackunit)
  (test-case "the effective potential and its second derivative"
    (for ([v (list potential right)]) (check-pred proved? v)))
  (test-case "the verdict on stability has the condition"
    (check-equal? (map expression (stability-conditions stability))
                  '((> (- (expt p 2) (* 4 A gMR)) 0))))
  (test-case "a factor of two is seen"
    (check-pred refuted? slip))
  (test-case "it sleeps above the critical momentum, and falls below"
    (check-= critical 0.0176580859665 1e-12)
    (check-true (< (farthest (* 1.1 critical)) 0.05))
    (check-true (> (farthest (* 0.9 critical)) 0.3))))
