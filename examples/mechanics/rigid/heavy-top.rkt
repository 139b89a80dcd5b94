#lang mechanics
;; A heavy top: nutation, precession, and when it sleeps (SICM 2.10 and 3.4).

(require mechanics/plot)
(provide picture)

(define ((V gMR) (up t (up theta phi psi) v)) (* gMR (cos theta)))
(define (L-top A C gMR) (- (T-body-Euler A A C) (V gMR)))

;; The momenta of φ and ψ are conserved, and so is the energy.
(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define L (L-top 'A 'C 'gMR))
(define (conserved? Q) (verdict-status (verify-conserved L Q state)))
(define p ((partial 2) L))
(list (conserved? (ref p 1)) (conserved? (ref p 2)) (conserved? (Lagrangian->energy L)))

;; The top of the book, let go at the tilt 0.4 against the sense in which it goes round.
(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define start (up 0 (up 0.4 0 0) (up 0 -10 200)))
(define sysder (Lagrangian->state-derivative (L-top A C gMR)))
(define top (evolve-trajectory sysder start 2 #:tolerance 1e-13))
(nutation-range A C gMR start)

;; The axis, drawn by its longitude and its tilt: it loops.
(define picture
  (frame 0. 5. 0.3 0.9 #:width 500 #:height 300 #:x-label "φ" #:y-label "θ"))
(plot-parametric picture
                 (lambda (t) (up (ref (top t) 1 1) (ref (top t) 1 0)))
                 0. 1. 0.002)
picture

;; Upright: stable if it spins fast enough.
(define ((upright omega A C gMR) (up t theta thetadot))
  (- (* 1/2 A (square thetadot)) ((V_eff (* C omega) A C gMR) theta)))
(define verdict
  (assuming ('(> A 0) '(> C 0))
    (equilibrium-stability (upright 'omega 'A 'C 'gMR) 0)))
verdict
(critical-spin A C gMR)

;; By motion, from a tilt of a thousandth: how far it leans within 10 s.
(define (leans spin)
  (define motion
    (evolve-trajectory sysder (up 0 (up 1e-3 0 0) (up 0 0 spin)) 10 #:tolerance 1e-12))
  (for/fold ([most 0]) ([t (in-range 0 10 1/50)]) (max most (abs (ref (motion t) 1 0)))))
(define faster (leans 140))
(define slower (leans 127))
(list (< faster 0.01) (> slower 0.5))

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "heavy-top.png"))

(module+ test
  (require rackunit)
  (test-case "what is conserved"
    (for ([Q (list (ref p 1) (ref p 2) (Lagrangian->energy L))])
      (check-eq? (conserved? Q) 'proved)))
  (test-case "the range of the nutation, and that the axis keeps to it"
    (define range (nutation-range A C gMR start))
    (check-= (cadr range) .809714734259 1e-11)
    (for ([t (in-range 0 2 1/100)])
      (check-true (<= (- (car range) 1e-9) (ref (top t) 1 0) (+ (cadr range) 1e-9)))))
  (test-case "the axis goes backwards at its greatest height: it loops"
    (check-true (< (ref (top 0) 2 1) 0))
    (check-true (> (ref (top 1) 1 1) 4)))
  (test-case "upright, above and below the critical rate"
    (check-equal? (map expression (stability-conditions verdict))
                  '((> (- (* (expt C 2) (expt omega 2)) (* 4 A gMR)) 0)))
    (check-= (critical-spin A C gMR) 133.773378534 1e-9)
    (check-true (< faster 0.01))
    (check-true (> slower 0.5))))
