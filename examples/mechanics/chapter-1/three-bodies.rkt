#lang mechanics
;; The restricted three-body problem and Jacobi's constant (SICM 1.8, pp. 86-88).

(require mechanics/book)

(define local (up 't (up 'x 'y) (up 'vx 'vy)))

;; Two bodies circle; on axes at rest the third one's Lagrangian depends on the time.
(define V (restricted-three-body-potential 'a 'GM_0 'GM_1 'm))
(define Omega (sqrt (/ (+ 'GM_0 'GM_1) (expt 'a 3))))
(define turning (compose (L0 'm V) (F->C (rotating->inertial Omega))))

;; On axes that turn with them it does not.
(verify-equal (turning local) ((LR3B 'm 'a 'GM_0 'GM_1) local))

;; So an energy is conserved, though it is not the energy on axes at rest.
(define L (LR3B1 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1))
(define Jacobi (Lagrangian->energy L))
(Jacobi local)
(prove-zero (* ((D Jacobi) local) ((Lagrangian->state-derivative L) local)))

;; A motion about the heavier body, and what the constant does meanwhile.
(define constant (Lagrangian->energy (LR3B 1 1 0.9 0.1)))
(define orbit
  (evolve-trajectory (Lagrangian->state-derivative (LR3B 1 1 0.9 0.1))
                     (up 0 (up 0.4 0.3) (up 0.2 0.9)) 5 #:tolerance 1e-12))
(for ([t 6]) (printf "~a  ~a\n" (coordinate (orbit t)) (constant (orbit t))))

(module+ test
  (require rackunit)
  (test-case "turning with the bodies takes the time out"
    (check-eq? (verdict-status (verify-equal (turning local) ((LR3B 'm 'a 'GM_0 'GM_1) local)))
               'proved))
  (test-case "Jacobi's constant is conserved, by proof and along a motion"
    (check-eq? (verdict-status
                (prove-zero (* ((D Jacobi) local) ((Lagrangian->state-derivative L) local))))
               'proved)
    (for ([t (in-range 0 5 0.1)])
      (check-= (constant (orbit t)) (constant (orbit 0)) 1e-9))))
