#lang mechanics
;; Exercise 2.15 (SICM 2.10): nutation of the top
;; Checked: the energy of the tilt alone, its motion, and its turning points
;; How: by verdicts; and numbers of a motion against the potential

;; Write the energy with the tilt θ and θ̇ as its only variables, given the two momenta that are
;; conserved; follow the top of the figure in time; and say what the energy tells of it.

(define ((V gMR) (up t (up theta phi psi) v)) (* gMR (cos theta)))
(define (L-top A C gMR) (- (T-body-Euler A A C) (V gMR)))
(define L (L-top 'A 'C 'gMR))
(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define p ((partial 2) L))

;; The momenta of φ and ψ, and the energy that is left.
(list (verdict-status (verify-conserved L (ref p 1) state))
      (verdict-status (verify-conserved L (ref p 2) state)))
(define (attempt p_phi p_psi)
  (+ (* 1/2 'A (square 'thetadot))
     (/ (square (- p_phi (* p_psi (cos 'theta)))) (* 2 'A (square (sin 'theta))))
     (/ (square p_psi) (* 2 'C))
     (* 'gMR (cos 'theta))))
(define (with-momenta e) (e (ref (p state) 1) (ref (p state) 2)))
(define right (verify-equal ((Lagrangian->energy L) state) (with-momenta attempt)))
right

;; A slip: the energy of the spin forgotten.  It is a constant, so θ moves as it did.
(define (slip p_phi p_psi) (- (attempt p_phi p_psi) (/ (square p_psi) (* 2 'C))))
(define wrong (verify-equal ((Lagrangian->energy L) state) (with-momenta slip)))
wrong

;; The top of the figure: it nods between the two tilts where all energy is potential.
(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define start (up 0 (up 0.4 0 0) (up 0 -10 200)))
(define turns (event (lambda (s) (ref s 2 0))))
(define top
  (evolve-trajectory (Lagrangian->state-derivative (L-top A C gMR)) start 2
                     #:tolerance 1e-13 #:events turns))
(define tilts
  (for/list ([o (trajectory-events top)]) (ref (occurrence-state o) 1 0)))
(define range (nutation-range A C gMR start))
(define (near? a b) (< (abs (- a b)) 1e-9))
(for/and ([tilt tilts]) (or (near? tilt (car range)) (near? tilt (cadr range))))

;; A fast top, let go at rest but for its spin ω, nods at the rate C ω/A, from 0.4 to very little
;; more.
(define (released spin)
  (define motion
    (evolve-trajectory (Lagrangian->state-derivative (L-top A C gMR))
                       (up 0 (up 0.4 0 0) (up 0 0 spin)) (/ (* 8 A) (* C spin))
                       #:tolerance 1e-13 #:events turns))
  (for/first ([o (trajectory-events motion)] #:when (> (time (occurrence-state o)) 0))
    (time (occurrence-state o))))
(define (nodding-rate spin) (/ :pi (released spin)))
(for/list ([spin '(400 2000 10000)]) (/ (nodding-rate spin) (/ (* C spin) A)))

(module+ test
  (require rackunit)
  (test-case "the energy of the tilt alone"
    (check-pred proved? right))
  (test-case "the slip is a constant away"
    (check-pred refuted? wrong)
    (check-pred proved?
                (verify-equal (verdict-residual wrong) (/ (square (ref (p state) 2)) (* 2 'C)))))
  (test-case "it nods between two tilts"
    (check-= (cadr range) .809714734259 1e-11)
    (check-true (> (length tilts) 5))
    (for ([tilt tilts] [k (in-naturals)])
      (check-= tilt (if (even? k) (cadr range) (car range)) 1e-9)))
  (test-case "a fast top nods at its own rate"
    (check-= (nodding-rate 10000) (/ (* C 10000) A) 1)))
