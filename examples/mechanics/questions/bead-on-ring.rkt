#lang mechanics
;; A bead on a ring that turns about its vertical diameter: where it stays, whether it
;; does, and how it swings there.  theta is measured from the bottom.

(define ((L-ring m R g omega) (up t theta thetadot))
  (+ (* 1/2 m (square R) (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))
(define L (L-ring 'm 'R 'g 'omega))
(define bead (up 't 'theta 'thetadot))

(define (report e)
  (define q (equilibrium-coordinates e))
  (print-expression (list q (small-oscillation-frequencies L q)))
  (printf "~a\n" (equilibrium-stability L q)))

(assume '(> m 0) '(> R 0) '(> g 0))
(for-each report (equilibria L bead))

;; With numbers, g = 10 and R = 1: slower and faster than the critical ω² = 10.
(define (at-speed omega)
  (for/list ([e (equilibria (L-ring 1 1 10 omega) bead)])
    (define q (equilibrium-coordinates e))
    (list q (stability-kind (equilibrium-stability (L-ring 1 1 10 omega) q)))))
(at-speed 3)
(at-speed 4)

;; The energy is no conserved quantity of the bead by itself; this is.
(define (T+V (up t theta thetadot))
  (- (* 1/2 'm (square 'R) (+ (square thetadot) (square (* 'omega (sin theta)))))
     (* 'm 'g 'R (cos theta))))
(verdict-status (verify-conserved L T+V bead))
(verdict-status (verify-conserved L (Lagrangian->energy L) bead))

(module+ test
  (require rackunit)
  (define (kinds omega) (map cadr (at-speed omega)))
  (test-case "the bottom gives up its stability to two new equilibria"
    (check-equal? (kinds 3) '(stable unstable))
    (check-equal? (kinds 4) '(stable stable unstable unstable)))
  (test-case "frequencies on both sides"
    (define (frequencies omega q) (small-oscillation-frequencies (L-ring 1 1 10 omega) q))
    (check-= (car (frequencies 3 0.0)) 1 1e-12)
    (check-= (car (frequencies 4 (acos 10/16))) (sqrt (- 16.0 100/16)) 1e-12))
  (test-case "what is conserved"
    (check-pred refuted? (verify-conserved L T+V bead))
    (check-pred proved? (verify-conserved L (Lagrangian->energy L) bead))))
