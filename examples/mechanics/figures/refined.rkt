#lang mechanics
;; The pendulum by two steps of perturbation theory, for figures 7.5 to 7.7.
;;
;; W removes ε.  Of what is then of the order ε², αβ²/(4p²) (1 − cos 2θ), the second generator
;; removes all, or only what turns; the rest stays in the Hamiltonian by which the rotor moves on.
;; Series are summed up to ε⁴: four terms with W, two with the second generator.
;;
;; Note: the book's (7.29) and (7.32) print sin 2θ with a plus.  Its own condition (7.28) asks for a
;; minus, as the test of figure 7.5 proves.

(require mechanics/book "rotor.rkt")

(provide W-secular W-periodic two-steps)

;; (7.29), and (7.32)
(define ((W-periodic alpha beta) (up t theta p))
  (/ (* -1 (square alpha) (square beta) (sin (* 2 theta))) (* 8 (cube p))))
(define ((W-secular alpha beta) (up t theta p))
  (+ (/ (* (square alpha) (square beta) theta) (* 4 (cube p)))
     ((W-periodic alpha beta) (up t theta p))))

;; W-2 : the second generator; energy : of the rotor, a function of p and ε
;; (((two-steps W-2 energy) state) t) : the state at a time
(define ((two-steps W-2 energy #:epsilon [epsilon 1] #:order [order 4]) state)
  (define (step W power sign)
    (Lie-transformation (W alpha beta) (* sign (expt epsilon power)) (quotient order power)))
  (define-values (to-first to-second) (values (step W 1 -1) (step W-2 2 -1)))
  (define-values (from-first from-second) (values (step W 1 1) (step W-2 2 1)))
  (define new (to-second (to-first state)))
  (define rate ((D (lambda (p) (energy p epsilon))) (momentum new)))
  (lambda (t)
    (from-first (from-second (up t (+ (coordinate new) (* rate t)) (momentum new))))))
