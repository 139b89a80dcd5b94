#lang racket/base
;; A Hamiltonian of one coordinate whose state is taken apart by a pattern was taken for a
;; Lagrangian: the pendulum hanging down was unstable, of p²/2 + V with V for −V.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (H (up t q p)) (+ (/ (square p) 2) (- 1 (cos q))))
(define (H-two (up t (up x y) p)) (+ (/ (square p) 2) (square x) (square y)))

(define (H-down (up t q (down px py))) (+ (square px) (square py) (square q)))

(define (refused who name)
  (string-append who ": this is called a Hamiltonian, and nothing else tells it from a Lagrangian: "
                 name "\n  a Hamiltonian is made known by (make-Hamiltonian " name ")"
                 "\n  of a Lagrangian, take another name"))

(says
 [(equilibrium-stability H 0) (refused "equilibrium-stability" "H")]
 [(equilibrium-stability H-two (up 0 0)) (refused "equilibrium-stability" "H-two")]
 [(find-equilibrium H 0.1) (refused "find-equilibrium" "H")]
 [(verify-equilibrium H 0) (refused "verify-equilibrium" "H")]
 [(normal-modes H 0) (refused "normal-modes" "H")]
 [(small-oscillation-frequencies H 0) (refused "small-oscillation-frequencies" "H")])

(test-case "made known it is judged: at rest below, not above"
  (check-equal? (stability-kind (equilibrium-stability (make-Hamiltonian H) 0)) 'stable)
  (check-equal? (stability-kind (equilibrium-stability (make-Hamiltonian H) pi)) 'unstable)
  (check-true (proved? (verify-equilibrium (make-Hamiltonian H) 0))))

(test-case "of several coordinates the momenta tell, where they are taken apart"
  (check-equal? (stability-kind (equilibrium-stability H-down (up 0 0))) 'stable)
  (check-equal? (stability-kind (equilibrium-stability (make-Hamiltonian H-two) (up 0 0))) 'stable))

(test-case "Lagrangians are taken by any other name"
  (define (L (up t q v)) (- (/ (square v) 2) (- 1 (cos q))))
  (define (Lagrangian (up t q v)) (L (up t q v)))
  (for ([f (list L Lagrangian (lambda (s) (L s)))])
    (check-equal? (stability-kind (equilibrium-stability f 0)) 'stable)))
