#lang racket/base
;; SICM 3.3, One Degree of Freedom (pp. 222-225), with the pendulum of Figure 3.4.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define state (up 't 'theta 'p_theta))

;; kg, m, m/s²
(define g 9.8)
(define L (L-pendulum 'g 'm 'l))
(define H (Lagrangian->Hamiltonian L))
(define H-figure (Lagrangian->Hamiltonian (L-pendulum g 1. 1.)))
(define (energy theta p) (H-figure (up 0. theta p)))
(define (advance start t)
  ((state-advancer (lambda () (Hamiltonian->state-derivative H-figure))) start t 1e-12))

;; ---------------------------------------------------------------------------
;; Conservation of energy, and its use

(test-case "the Hamiltonian of the pendulum, and Hamilton's equations"
  (check-prints (H state)
                '(- (/ (* 1/2 (expt p_theta 2)) (* (expt l 2) m)) (* g l m (cos theta))))
  (check-prints ((Hamiltonian->state-derivative H) state)
                '(up 1 (/ p_theta (* (expt l 2) m)) (* -1 g l m (sin theta)))))

(test-case "a Hamiltonian without the time is conserved, whatever it is"
  (define F (literal-function 'F (-> (X Real Real) Real)))
  (define fixed (make-Hamiltonian (lambda (s) (F (coordinate s) (momentum s)))))
  (check-pred proved? (verify-conserved fixed fixed (up 't 'q 'p)))
  (check-pred proved? (verify-conserved H H state)))

(test-case "by it the momentum is eliminated: Dq = f(q), a quadrature"
  (define energy-symbol 'E)
  (define momentum-there
    (sqrt (* 2 'm (square 'l) (+ energy-symbol (* 'm 'g 'l (cos 'theta))))))
  (assuming ('(> m 0) '(> l 0))
    (check-identity (H (up 't 'theta momentum-there)) energy-symbol)))

(test-case "the quadrature gives the period that motions have"
  ;; T = 4 √(l/g) K(sin θ₀/2), for the amplitude 1
  (define period (* 4 (sqrt (/ 1 g)) (first-elliptic-integral (sin 1/2))))
  (check-= period 2.140228719018093 1e-12)
  (define half (advance (up 0. 1. 0.) (/ period 2)))
  (check-close (coordinate half) -1. 1e-9)
  (check-close (momentum half) 0. 1e-8))

(test-case "the state moves across the gradient of H"
  (define slope ((D H) state))
  (define flow ((Hamiltonian->state-derivative H) state))
  (check-identity (+ (* (ref slope 1) (ref flow 1)) (* (ref slope 2) (ref flow 2))) 0))

;; ---------------------------------------------------------------------------
;; Peaks, pits and saddles

(test-case "rest is where the gradient vanishes: hanging and upright"
  (check-equal? (map equilibrium-coordinates (equilibria H state)) '(0 :pi))
  (for ([theta '(0 :pi)])
    (check-identity ((Hamiltonian->state-derivative H) (up 't theta 0)) (up 1 0 0))))

(test-case "the pit is stable, the saddle is not"
  (assuming ('(> m 0) '(> l 0) '(> g 0))
    (check-eq? (stability-kind (equilibrium-stability H 0)) 'stable)
    (check-eq? (stability-kind (equilibrium-stability H ':pi)) 'unstable)
    (check-identity (((partial 1) ((partial 1) H)) (up 't 0 0)) (* 'g 'l 'm))
    (check-identity (((partial 1) ((partial 1) H)) (up 't ':pi 0)) (* -1 'g 'l 'm))
    (check-identity (((partial 2) ((partial 2) H)) (up 't 0 0)) (/ 1 (* 'm (square 'l))))))

(test-case "near the pit contours are ellipses, gone around at √(g/l)"
  (assuming ('(> m 0) '(> l 0) '(> g 0))
    (check-prints (small-oscillation-frequencies H 0) '((sqrt (/ g l))))))

;; ---------------------------------------------------------------------------
;; The separatrix, and the regions that it parts

(define top-energy (energy pi 0.))

(test-case "the contour of the saddle: p = ± 2 m l √(g l) cos θ/2"
  (define (p theta) (* 2 'm 'l (sqrt (* 'g 'l)) (cos (/ theta 2))))
  (check-identity (H (up 't 'theta (p 'theta))) (H (up 't ':pi 0)))
  (check-= (energy 0. (* 2 (sqrt g))) top-energy 1e-13))

(test-case "on it the pendulum comes near the upright rest and never gets there"
  ;; θ = 4 arctan(tanh(√(g/l) t/2)), p = 2 m l² √(g/l)/cosh(√(g/l) t)
  (define (theta t) (* 4 (atan (tanh (* 1/2 'w t)))))
  (define (p t) (/ (* 2 'm (square 'l) 'w) (cosh (* 'w t))))
  (define v
    (verify-Hamiltonian-solution (Lagrangian->Hamiltonian (L-pendulum (* 'l (square 'w)) 'm 'l))
                                 theta p))
  (check-pred proved? v)
  (check-true (< (coordinate (advance (up 0. 0. (* 2 (sqrt g))) 3.)) pi)))

(test-case "within it swings, outside it goes round, in either direction"
  (define (turned p) (coordinate (advance (up 0. 0. p) 10.)))
  (check-true (< (abs (turned (* 1.99 (sqrt g)))) pi))
  (check-true (> (turned (* 2.01 (sqrt g))) pi))
  (check-true (< (turned (* -2.01 (sqrt g))) (- pi)))
  (check-true (< (energy 0. (* 1.99 (sqrt g))) top-energy (energy 0. (* 2.01 (sqrt g))))))

;; ---------------------------------------------------------------------------
;; Other objects: a particle in a double well has two pits and a saddle between

(test-case "a double well: the separatrix is an eight"
  (define H-well
    (make-Hamiltonian (lambda (s) (+ (* 1/2 (square (momentum s)))
                                     (* 1/4 (square (- (square (coordinate s)) 1)))))))
  (check-equal? (map equilibrium-coordinates (equilibria H-well (up 't 'x 'p))) '(0 1 -1))
  (for ([x '(0 -1 1)] [kind '(unstable stable stable)])
    (check-eq? (stability-kind (equilibrium-stability H-well x)) kind))
  ;; asymptotic to the saddle at both ends
  (check-pred proved?
              (verify-Hamiltonian-solution H-well
                                           (lambda (t) (/ (sqrt 2) (cosh t)))
                                           (lambda (t) (/ (* -1 (sqrt 2) (sinh t))
                                                          (square (cosh t)))))))
