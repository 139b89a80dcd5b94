#lang racket/base
;; SICM 1.4, Computing Actions (pp. 14–23), in the reader's own language.

(require mechanics)

(provide L-free-particle test-path varied-free-particle-action L-harmonic)

;; A free particle of some mass: T, in any rectangular coordinates (p. 14).
(define ((L-free-particle mass) (up t q v))
  (* 1/2 mass (dot-product v v)))

;; A straight path at constant speed (p. 18).
(define (test-path t)
  (up (+ (* 4 t) 7)
      (+ (* 3 t) 5)
      (+ (* 2 t) 1)))

;; The action along q + ε η, where η vanishes at t1 and t2 (p. 18).
(define ((varied-free-particle-action mass q nu t1 t2) epsilon)
  (Lagrangian-action (L-free-particle mass)
                     (+ q (* epsilon (make-eta nu t1 t2)))
                     t1 t2))

;; A particle of mass m on a spring of stiffness k (p. 22).
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v))
     (* 1/2 k (square q))))
