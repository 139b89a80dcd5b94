#lang mechanics
;; Exercise 1.34 (SICM 1.8.3): a driven spherical pendulum
;; Checked: the Lagrangian, and what is conserved
;; How: against a falling particle; rates along the motions

;; A bob on a rod of length l swings in space while its pivot is moved up and down, z_s(t).
;; Find a Lagrangian and what its symmetry conserves.

(define ((L-falling m g) (up t (up x y z) v))
  (- (* 1/2 m (square v)) (* m g z)))
(define z_s (literal-function 'z_s))

;; The angle θ is that from straight down, φ goes round the vertical.
(define (from-angles local)
  (match (coordinate local)
    [(up theta phi)
     (up (* 'l (sin theta) (cos phi))
         (* 'l (sin theta) (sin phi))
         (- (z_s (time local)) (* 'l (cos theta))))]))
(define L (compose (L-falling 'm 'g) (F->C from-angles)))

(define state (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
(define attempt
  (let ([v_s ((D z_s) 't)])
    (- (* 1/2 'm (+ (square (* 'l 'thetadot)) (square (* 'l 'phidot (sin 'theta)))
                    (square v_s) (* 2 'l v_s 'thetadot (sin 'theta))))
       (* 'm 'g (- (z_s 't) (* 'l (cos 'theta)))))))
(define same (verify-equal (L state) attempt))
same

;; The pendulum may be turned about the vertical, so the momentum of φ is conserved.
(conserved-momenta L state)
(define momentum (verify-conserved L (ref ((partial 2) L) 1) state))
momentum

;; The energy does not, but would if the pivot's velocity and acceleration vanished.
(define energy (verify-conserved L (Lagrangian->energy L) state))
(verdict-status energy)
(define (at-rest residual)
  (for/fold ([r residual]) ([rate (list ((D z_s) 't) (((expt D 2) z_s) 't))])
    (substitute r rate 0)))
(define energy-at-rest (prove-zero (at-rest (verdict-residual energy))))
energy-at-rest

(module+ test
  (require rackunit)
  (test-case "the Lagrangian by hand"
    (check-pred proved? same))
  (test-case "the momentum about the vertical is conserved, the energy is not"
    (check-pred proved? momentum)
    (check-pred refuted? energy)
    (check-pred proved? energy-at-rest)))
