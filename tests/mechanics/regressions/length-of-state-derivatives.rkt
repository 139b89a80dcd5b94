#lang racket/base
;; Denominators in sines, rationalised, made state derivatives four times as long,
;; and a normal form was computed again for each size of ring that presentation
;; might need: a state derivative of two pendulums took ten times as long.

(require mechanics
         "../support/checks.rkt" "../bench/systems.rkt")

;; The symbols, numbers and operators one reads.
(define (length-as-read d)
  (if (pair? d) (apply + 1 (map length-as-read (cdr d))) 1))

(define (check-length L state longest)
  (define simple (simplify ((Lagrangian->state-derivative L) state)))
  (check <= (length-as-read (expression simple)) longest)
  (check-equal? (simplify simple) simple))

(test-case "two pendulums: the denominators are m₁ + m₂ sin²(θ₁ - θ₂)"
  (define acceleration
    (ref (simplify ((Lagrangian->state-derivative (chain-Lagrangian 2)) (chain-state 2))) 2))
  (check-equal?
   (expression acceleration)
   '(up (/ (* -1
              (+ (* g m1 (sin theta1))
                 (* m2
                    (+ (* g (cos theta2))
                       (* l1 (expt thetadot1 2) (cos (- theta1 theta2)))
                       (* l2 (expt thetadot2 2)))
                    (sin (- theta1 theta2)))))
           (* l1 (+ m1 (* m2 (expt (sin (- theta1 theta2)) 2)))))
        (/ (* (+ (* g (+ m1 m2) (cos theta1))
                 (* l1 (expt thetadot1 2) (+ m1 m2))
                 (* l2 m2 (expt thetadot2 2) (cos (- theta1 theta2))))
              (sin (- theta1 theta2)))
           (* l2 (+ m1 (* m2 (expt (sin (- theta1 theta2)) 2))))))))

(test-case "state derivatives are no longer than they were, and settled"
  (check-length (chain-Lagrangian 2) (chain-state 2) 96)
  (check-length (chain-Lagrangian 3) (chain-state 3) 284)
  (check-length (rigid-body-Lagrangian 'A 'B 'C) (Euler-state) 267)
  (check-length (Foucault-Lagrangian) (Foucault-state) 137))

(test-case "the restricted three-body problem keeps both radicals"
  (define residual (simplify (((Lagrange-equations (three-body-Lagrangian)) (plane-path)) 't)))
  (check <= (length-as-read (expression residual)) 155))
