#lang mechanics
;; Without secular terms  (SICM 7.2.2, Figure 7.7)
;;
;; The two steps of figure 7.5 again, but the second removes only what turns with the angle, and the
;; rest, αβ²/(4p²) ε², changes the frequency of the rotor.  Now the solution goes round a closed
;; curve as the pendulum, blue, does.

(require mechanics/plot mechanics/book "rotor.rkt" "refined.rkt")

;; (7.33)
(define (averaged p epsilon)
  (+ (/ (square p) (* 2 alpha))
     (* (square epsilon) (/ (* alpha (square beta)) (* 4 (square p))))))
(define told ((two-steps W-periodic averaged) (start 0.7)))
(define true (truth (start 0.7)))

(define picture (plane 0.25 0.8))
(draw-points picture true 100. 0.1 #:color 'blue)
(draw-points picture told 100. 0.1)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-7.png"))

(module+ test
  (require rackunit)
  (define state (up 't 'theta 'p))
  (test-case "generators and Hamiltonian are those that perturbation-series finds"
    (define P (perturbation-series (H0 'alpha) (H1 'beta) state #:order 2))
    (define Ws (perturbation-generators P))
    (check-pred proved? (verify-equal ((car Ws) state) ((W 'alpha 'beta) state)))
    (check-pred proved? (verify-equal ((cadr Ws) state) ((W-periodic 'alpha 'beta) state)))
    (check-pred proved?
                (verify-equal (series:sum ((perturbation-Hamiltonian P) state) 2)
                              (+ ((H0 'alpha) state)
                                 (/ (* (square 'epsilon) 'alpha (square 'beta))
                                    (* 4 (square 'p)))))))
  (test-case "each turn ends where it began, and takes as long as the pendulum's, to 3 %"
    (define T (turn-time told))
    (check-= (momentum (told (* 9 T))) (momentum (told 0.)) 1e-9)
    (check-= (/ T (turn-time true)) 1 0.03))
  (test-case "the curve is that of the pendulum, to 0.015"
    (for ([theta '(-3. -2. -1. 0. 1. 2. 3.)])
      (check-= (momentum (state-at told theta)) (momentum (state-at true theta)) 0.015)))
  (test-case "the frequency is told to the fourth order: with ε halved"
    (define (off epsilon)
      (define m ((two-steps W-periodic averaged #:epsilon epsilon #:order 8) (start 0.7)))
      (define E ((Hpendulum alpha (* epsilon beta)) (start 0.7)))
      (- (/ :2pi (turn-time m)) (pendulum-frequency alpha (* epsilon beta) E)))
    (check-= (/ (log (/ (off 1/8) (off 1/16))) (log 2)) 4 0.2)))
