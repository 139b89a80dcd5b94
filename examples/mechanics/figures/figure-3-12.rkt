#lang mechanics
;; A section of the driven pendulum  (SICM 3.6.1, Figure 3.12)
;;
;; A = 0.05 m, ω = 4.2 ω₀: islands about the pendulum that hangs and about those that go round once
;; in each period of the drive, and a chaotic zone where the separatrix was.

(require mechanics/plot "strobe.rkt")

(define T (strobe-map 0.05 4.2))
(define win
  (strobe-section 0.05 4.2 20. '((0.5 0.) (1. 0.) (1.5 0.) (1.9 0.) (3.1 0.5) (3.1 13.) (0. 11.)
                                 (3.1 -13.) (0. -11.) (0. 17.) (0. -17.) (0. 4.9))
                  300))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-12.png"))

(module+ test
  (require rackunit)
  (define (kind theta p) (fixed-point-kind (find-fixed-point T (up theta p))))
  (test-case "after one period, and after ten"
    (define (after n) ((iterated-map T n) 1. 0. list void))
    (check-= (car (after 1)) 0.1545220284860514 1e-9)
    (check-= (cadr (after 1)) -3.305964200270147 1e-9)
    (check-= (car (after 10)) 0.03176555779650096 1e-8))
  (test-case "hanging it is stable, upside down not; with the drive it goes round"
    (check-equal? (kind 0. 0.) 'elliptic)
    (check-equal? (kind 3.14 0.) 'hyperbolic)
    (check-equal? (kind 3.1 13.) 'elliptic)
    (check-equal? (kind 0. 13.) 'hyperbolic))
  (test-case "near the centre orbits are regular, where the separatrix was they are not"
    (check-true (rotation-regular? (rotation-number T (up 0.5 0.) 300 #:about (up 0 0))))
    (define growth (maximal-Lyapunov-exponent T (up 3.1 0.5) 100))
    (check-true (> (car (Lyapunov-values growth)) 0.1))))
