#lang mechanics
;; A composite section beside the true one  (SICM 7.4.1, Figure 7.10)
;;
;; The driven pendulum, γ = 1/4: left the solutions of the first order near its three resonances,
;; each where it is meant for, right the pendulum itself.  Islands and the curves between them are
;; the same; small islands between the large ones, and chaos at their edges, are not in the theory.

(require mechanics/plot "resonances.rkt" "composite.rkt")

(define gamma 1/4)
(define starts
  '((0. 0.5) (0. 1.) (0. 1.5) (0. 1.9) (3.1 0.3) (3.1 -0.3) (0. 2.3) (0. -2.3) (0. 2.8) (0. 3.2)
    (0. -2.8) (0. -3.2) (3.1 5.2) (3.1 5.5) (3.1 5.8) (3.1 -5.2) (3.1 -5.5) (3.1 -5.8) (0. 3.6)
    (0. -3.6) (0. 6.3) (0. -6.3) (0. 7.) (0. -7.)))
(define picture (side-by-side gamma starts 120))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-10.png"))

(module+ test
  (require rackunit)
  (test-case "each island is as wide as the theory says, to 0.07"
    (for ([k resonances] [theta (list 0. pi pi)] [p '(0. 5. -5.)])
      (for ([told (edges gamma k)] [found (island-edges gamma k theta p)])
        (check-= told found 0.07))))
  (test-case "neighbouring solutions fit together: a curve between two by both theories"
    (define (heights k)
      (define motion ((resonant-motion gamma k) 0. 2.8))
      (for/list ([j 100]) (ref (motion (/ (* j :2pi) omega)) 1)))
    (define-values (by-0 by-omega) (values (heights '(0 1)) (heights '(-1 1))))
    (check-= (apply max by-0) (apply max by-omega) 0.2)
    (check-= (apply min by-0) (apply min by-omega) 0.2)))
