#lang mechanics
;; Exercise 1.10 (SICM 1.5): Lagrangians with accelerations
;; Checked: the equations for a Lagrangian that depends on accelerations
;; How: against Lagrange-equations of order 2, for an arbitrary Lagrangian

;; A Lagrangian depends on time, position, velocity and acceleration.  Which equation makes
;; its action stationary?

(define L (literal-function 'L (-> (UP Real Real Real Real) Real)))
(define q (literal-function 'q))
(define (along f) (compose f (Gamma q 4)))

(define attempt
  (+ ((expt D 2) (along ((partial 3) L)))
     (- (D (along ((partial 2) L))))
     (along ((partial 1) L))))

;; One sign for all terms, as if every integration by parts were done once.
(define slip
  (+ (- ((expt D 2) (along ((partial 3) L))))
     (- (D (along ((partial 2) L))))
     (along ((partial 1) L))))

;; The overall sign is a matter of taste.
(define residual (- ((Lagrange-equations L #:order 2) q)))
(define right (verify-equal residual attempt))
(define wrong (verify-equal residual slip))
right
(verdict-status wrong)

;; Twice the term with the wrong sign is left over.
(define twice (verify-equal (verdict-residual wrong)
                            (* 2 (((expt D 2) (along ((partial 3) L))) 't))))
twice

(module+ test
  (require rackunit)
  (test-case "signs alternate"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? twice)))
