#lang mechanics
;; The phase plane of the undriven pendulum  (SICM 4.1, Figure 4.1)
;;
;; Three regions, two kinds of motion: it swings within the eye, and goes round above it and below.
;; One call finds the rests, the orbits and, in red, the separatrix.

(require mechanics/plot mechanics/book)

;; kg, m, m/s²
(define-values (m l g) (values 1. 1. 9.8))
(define H (Lagrangian->Hamiltonian (L-pendulum g m l)))

(define picture
  (plot-phase-portrait
   (frame :-pi :pi -15. 15. #:width 450 #:height 400 #:x-label "θ" #:y-label "p_θ")
   H #:orbits 16))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-1.png"))

(module+ test
  (require rackunit)
  (define (H-at theta p) (H (up 0. theta p)))
  (define advance (state-advancer Hamiltonian->state-derivative H))
  (define (turned p) (coordinate (advance (up 0. 0. p) 20. 1e-10)))
  (define top (H-at pi 0.))
  (test-case "in the three regions it swings, goes round forwards, and backwards"
    (define edge (* 2 (sqrt g)))
    (check-= (H-at 0. edge) top 1e-12)
    (for ([p (list 1. 5. (* 0.999 edge) (* -0.999 edge))]) (check-true (< (abs (turned p)) pi)))
    (for ([p (list (* 1.001 edge) 10.)])
      (check-true (> (turned p) :2pi))
      (check-true (< (turned (* -1 p)) (- :2pi)))))
  (test-case "it rests hanging, where it is stable, and upright, where it is not"
    (define (slopes theta) ((D (lambda (p) (H-at (ref p 0) (ref p 1)))) (up theta 0.)))
    (define (curvature theta) (((expt D 2) (lambda (x) (H-at x 0.))) theta))
    (for ([theta (list 0. pi)] [x 2])
      (check-= (ref (slopes theta) 0) 0 1e-14)
      (check-= (ref (slopes theta) 1) 0 1e-14))
    (check-true (> (curvature 0.) 0))
    (check-true (< (curvature pi) 0)))
  (test-case "asymptotic motions come to the top ever more slowly, and do not go over it"
    (define start (up 0. 0. (* 2 (sqrt g))))
    (define (left t) (- pi (coordinate (advance start t 1e-13))))
    (check-= (left 1.5) (* 4 (atan (exp (* -1.5 (sqrt g))))) 1e-9)
    (check-= (/ (left 3.) (left 2.)) (exp (- (sqrt g))) 1e-4)))
