#lang racket/base
;; SICM 3.4, Phase Space Reduction (pp. 224-236).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define top (L-axisymmetric-top 'A 'C 'gMR))
(define H-top (Lagrangian->Hamiltonian top))
(define state (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))

(test-case "p. 229: the Hamiltonian of the axisymmetric top"
  (check-prints (H-top state)
                '(+ (* gMR (cos theta))
                    (/ (* 1/2 (expt p_theta 2)) A)
                    (/ (expt (- p_phi (* p_psi (cos theta))) 2) (* 2 A (expt (sin theta) 2)))
                    (/ (* 1/2 (expt p_psi 2)) C)))
  (check-identity (H-top state)
                  (+ (/ (square 'p_theta) (* 2 'A))
                     (/ (square 'p_psi) (* 2 'C))
                     (/ (square (- 'p_phi (* 'p_psi (cos 'theta))))
                        (* 2 'A (square (sin 'theta))))
                     (* 'gMR (cos 'theta)))))

(test-case "p_phi and p_psi are conserved, θ moves by itself"
  (define slope ((Hamiltonian->state-derivative H-top) state))
  (check-identity (ref slope 2 1) 0)
  (check-identity (ref slope 2 2) 0)
  (for ([Q (list H-top
                 (compose (component 1) momentum)
                 (compose (component 2) momentum))])
    (check-identity ((Poisson-bracket Q H-top) state) 0)))

(test-case "with p_phi = p_psi the effective potential has no pole at θ = 0"
  (define p 'p)
  (define reduced (H-top (up 't (up 'theta 'phi 'psi) (down 'p_theta p p))))
  (check-identity reduced
                  (+ (/ (square 'p_theta) (* 2 'A)) (/ (square p) (* 2 'C))
                     (/ (* (square p) (square (tan (/ 'theta 2)))) (* 2 'A))
                     (* 'gMR (cos 'theta)))))

(define (energy-matrix p) ; ∂²/∂θ² of the effective potential at θ = 0
  (define ((U p) theta)
    (+ (/ (* (square p) (square (tan (/ theta 2)))) (* 2 'A)) (* 'gMR (cos theta))))
  (((expt D 2) (U p)) 0))

(test-case "a sleeping top is stable if p² > 4 A gMR"
  (check-identity (energy-matrix 'p) (- (/ (square 'p) (* 4 'A)) 'gMR)))

;; A = 6.96e-4, C = 1.32e-4, gMR = .112: the critical momentum and rate of rotation.
(test-case "the critical momentum of the top in the figures"
  (define p-critical (sqrt (* 4 6.96e-4 .112)))
  (check-close (list p-critical (/ p-critical 1.32e-4)) '(.0176580859665 133.773378534) 1e-8))

(test-case "the top moves as it does in figures 2.5 to 2.8"
  (define L (L-axisymmetric-top 6.96e-4 1.32e-4 .112))
  (define start ((Lstate->Hstate L) (up 0 (up 0.4 0.0 0.0) (up 0.0 -10.0 200.0))))
  (define (system) (Hamiltonian->state-derivative (Lagrangian->Hamiltonian L)))
  (define end ((state-advancer system) start 1 1e-13))
  (check-close (list (coordinate end) (ref (momentum end) 0))
               '((.7636717173299069 4.989548088316894 187.388061898977) -.002389367104876363)
               1e-8)
  ;; and it nods between two angles
  (define motion (evolve-trajectory (system) start 2 #:tolerance 1e-12))
  (define angles (for/list ([i 20001]) (ref (coordinate (motion (/ i 10000.0))) 0)))
  (check-close (list (apply min angles) (apply max angles)) '(.4 .809714734259) 1e-6))

;; ---------------------------------------------------------------------------
;; 3.4.1 Routhians

(define ((L-two m_x k_x m_y k_y) (up t (up x y) (up vx vy)))
  (- (+ (* 1/2 m_x (square vx)) (* 1/2 m_y (square vy)))
     (+ (* 1/2 k_x (square x)) (* 1/2 k_y (square y)) (* x (square y)))))

(define L2 (L-two 'm_x 'k_x 'm_y 'k_y))
(define R2 (Lagrangian->Routhian L2))
(define mixed (up 't (up 'x 'y) (up 'vx 'p_y)))

(test-case "Exercise 3.9: the Routhian of two oscillators"
  (check-identity (R2 mixed)
                  (+ (/ (square 'p_y) (* 2 'm_y)) (* -1/2 'm_x (square 'vx))
                     (* 1/2 'k_x (square 'x)) (* 1/2 'k_y (square 'y)) (* 'x (square 'y)))))

(test-case "Routh's equations: those of Lagrange and of Hamilton"
  (check-identity (((Routh-equations R2) (literal-function 'x) (literal-function 'y)
                                         (literal-function 'p_y))
                   't)
                  (let-values ([(x y p) (values (literal-function 'x) (literal-function 'y)
                                                (literal-function 'p_y))])
                    (up (- (+ (* 'm_x (((expt D 2) x) 't)) (* 'k_x (x 't)) (square (y 't))))
                        (up 0
                            (- ((D y) 't) (/ (p 't) 'm_y))
                            (+ ((D p) 't) (* 'k_y (y 't)) (* 2 (x 't) (y 't))))))))

(test-case "the motion of a Routhian is that of its Lagrangian"
  (define local ((Routhian-state->Lagrangian-state R2) mixed))
  (check-prints ((Lagrangian-state->Routhian-state L2) local) '(up t (up x y) (up vx p_y)))
  (define a ((Lagrangian->acceleration L2) local))
  (check-identity ((Routhian->acceleration R2) mixed) (ref a 0))
  (define slope ((Routhian->state-derivative R2) mixed))
  (check-identity (ref slope 1) (up 'vx (/ 'p_y 'm_y)))
  (check-identity (ref slope 2 1) (* 'm_y (ref a 1))))

(test-case "the top, with two coordinates and their momenta"
  (define (order s) (up (ref (coordinate s) 0) (ref (coordinate s) 1 0) (ref (coordinate s) 1 1)))
  (define L (compose top (F->C order)))
  (define R (Lagrangian->Routhian L))
  (define s (up 't (up 'theta (up 'phi 'psi)) (up 'thetadot (down 'p_phi 'p_psi))))
  (check-identity (R s)
                  (- (H-top (up 't (up 'theta 'phi 'psi) (down 0 'p_phi 'p_psi)))
                     (* 1/2 'A (square 'thetadot))))
  (define slope ((Routhian->state-derivative R) s))
  (check-identity (ref slope 2 1) (down 0 0))
  (check-identity (* 'A ((Routhian->acceleration R) s))
                  (ref ((Hamiltonian->state-derivative H-top) state) 2 0)))

(test-case "accelerations of a Routhian that depends on time, and on y in its momenta"
  (define ((L-odd) (up t (up x y) (up vx vy)))
    (+ (* 1/2 (exp t) (square vx)) (* 1/2 (+ 1 (square x)) (square vy)) (* y vx vy) (* x y)))
  (define R (Lagrangian->Routhian (L-odd)))
  (define local ((Routhian-state->Lagrangian-state R) mixed))
  (check-identity ((Routhian->acceleration R) mixed)
                  (ref ((Lagrangian->acceleration (L-odd)) local) 0)))
