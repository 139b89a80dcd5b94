#lang mechanics
;; Exercise 2.12 (SICM 2.9): rates of the Euler angles
;; Checked: the rates that belong to an angular velocity on the body
;; How: put into ω of a state; against DM = M A(ω)

;; Euler's equations give ω on the body; at which rates do θ, φ and ψ change then?

(define angles (up 'theta 'phi 'psi))
(define omega (up 'omega^a 'omega^b 'omega^c))

;; An attempt: ω_a and ω_b seen along the line of nodes and across it.
(define (rates sign)
  (define along (- (* 'omega^a (cos 'psi)) (* 'omega^b (sin 'psi))))
  (define across (+ (* 'omega^a (sin 'psi)) (* 'omega^b (cos 'psi))))
  (define phidot (/ across (sin 'theta)))
  (up along phidot (+ 'omega^c (* sign phidot (cos 'theta)))))
(define right (verify-equal (Euler-state->omega-body (up 't angles (rates -1))) omega))
right

;; The same from the matrix: along the motion it changes at M A(ω).
(define DM ((D (lambda (s) (Euler->M (+ angles (* s (rates -1)))))) 0))
(define by-matrix
  (verify-equal DM (* (Euler->M angles) (3vector-components->antisymmetric omega))))
by-matrix

;; They have a pole where θ = 0: there φ and ψ turn about one axis.
(define (at-pole) (substitute (ref (rates -1) 1) 'theta 0))

;; A slip: ψ̇ with the other sign of the precession.
(define slip (verify-equal (Euler-state->omega-body (up 't angles (rates +1))) omega))
(verdict-status slip)
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "the rates, by ω and by the matrix"
    (check-pred proved? right)
    (check-pred proved? by-matrix))
  (test-case "they are singular at the pole"
    (check-exn exn:fail:contract:divide-by-zero? at-pole))
  (test-case "the slip is seen in the spin alone"
    (check-pred refuted? slip)
    (check-equal? (map (lambda (i) (ref (verdict-residual slip) i)) '(0 1)) '(0 0))))
