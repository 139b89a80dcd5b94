#lang mechanics
;; A section of the motion of Hénon and Heiles  (SICM 3.6.3, Figure 3.20)
;;
;; Energy 1/8: islands with curves, and between them orbits that fill an area.

(require mechanics/plot "star.rkt")

(define T (star-map 1/8))
(define win
  (star-section 1/8 '((0. 0.1) (0.1 0.) (0.2 0.) (0.3 0.) (0.4 0.) (-0.15 0.) (-0.3 0.)
                          (0. 0.3) (0. -0.3) (0.5 0.1))
                300))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-20.png"))

(module+ test
  (require rackunit)
  (test-case "the first crossing"
    (define once (T 0.1 0. list void))
    (check-= (car once) 0.3208297390186 1e-9)
    (check-= (cadr once) -0.07183026254416 1e-9))
  (test-case "some orbits are regular and some are not"
    (define (growth y) (car (Lyapunov-values (maximal-Lyapunov-exponent T (up y 0.) 150))))
    (check-true (< (growth 0.3) 0.06))
    (check-true (> (growth -0.15) 0.08))))
