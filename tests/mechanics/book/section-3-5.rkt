#lang racket/base
;; SICM 3.5, Phase Space Evolution (pp. 236-239).

(require mechanics
         mechanics/book
         mechanics/plot
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define state (up 't 'theta 'p_theta))
(define sysder (H-pend-sysder 'm 'l 'g 'a 'omega))

(test-case "p. 237: the Hamiltonian of the driven pendulum"
  (check-prints ((Lagrangian->Hamiltonian (L-pend 'm 'l 'g (literal-function 'y_s))) state)
                '(+ (* g m (- (y_s t) (* l (cos theta))))
                    (* -1/2 m (expt (cos theta) 2) (expt ((D y_s) t) 2))
                    (/ (* -1 p_theta (sin theta) ((D y_s) t)) l)
                    (/ (* 1/2 (expt p_theta 2)) (* (expt l 2) m)))))

(test-case "p. 237: its state derivative, from H and from L"
  (define L (L-periodically-driven-pendulum 'm 'l 'g 'a 'omega))
  (define local ((Hstate->Lstate (Lagrangian->Hamiltonian L)) state))
  (check-identity (ref (sysder state) 1) (velocity local))
  (define (P s) (((partial 2) L) s))
  (check-identity (ref (sysder state) 2)
                  (* ((D P) local) ((Lagrangian->state-derivative L) local))))

(test-case "it keeps areas in the phase plane"
  (check-identity ((phase-space-divergence sysder) state) 0))

(test-case "p. 238: it moves as in chapter 1"
  (define g 9.8)
  (define omega (* 2 (sqrt g)))
  (define end ((state-advancer H-pend-sysder 1.0 1.0 g 0.1 omega) (up 0 1.0 0.0) 1 1e-13))
  (check-close (coordinate end) -1.03011568739188687 1e-9)
  ;; θ̇ from p_θ: the pivot has the velocity −A ω sin ωt.
  (define local
    ((Hstate->Lstate (Lagrangian->Hamiltonian
                      (L-periodically-driven-pendulum 1.0 1.0 g 0.1 omega)))
     end))
  (check-close (velocity local) -1.40985359335821735 1e-9))

(test-case "p. 238: what is plotted: θ within a turn, and its momentum"
  (define win (frame (- pi) pi -10.0 10.0))
  (define points '())
  ((evolve H-pend-sysder 1.0 1.0 9.8 0.1 (* 2 (sqrt 9.8)))
   (up 0 1.0 0.0)
   (lambda (s) ((monitor-p-theta win) s) (set! points (cons s points)))
   0.05 1.0 1e-10)
  (check-equal? (length points) 21))
