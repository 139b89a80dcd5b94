#lang mechanics
;; A perturbative solution and the true one  (SICM 7.2, Figure 7.2)
;;
;; One step of perturbation theory, with the terms of its Lie series up to the fourth order, and
;; the pendulum itself, blue, by elliptic functions.  More terms would not bring the two together:
;; the step leaves ε² in the Hamiltonian.

(require mechanics/plot mechanics/book "rotor.rkt")

(define-values (told true) (values ((first-step 4) (start 0.7)) (truth (start 0.7))))

(define picture (plane 0.25 0.8))
(draw-turn picture told)
(draw-turn picture true #:color 'blue)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-2.png"))

(module+ test
  (require rackunit)
  (test-case "they begin together, and the true one is the lower of the two"
    (check-= (momentum (told 0.)) 0.7 0.002)
    (for ([theta (list :-pi -2. -1. 1. 2. pi)])
      (check-true (> (momentum (state-at told theta)) (momentum (state-at true theta))))
      (check-= (momentum (state-at told theta)) (momentum (state-at true theta)) 0.04)))
  (test-case "the true one keeps its energy, and takes longer for a turn"
    (define E ((Hpendulum alpha beta) (start 0.7)))
    (check-= (momentum (state-at true pi)) (sqrt (* 2 (- E beta))) 1e-9)
    (check-= (turn-time true) (/ :2pi (pendulum-frequency alpha beta E)) 1e-8)
    (check-true (< (turn-time told) (turn-time true))))
  (test-case "what is missed in the frequency is of the second order: with ε halved"
    ;; to a high order of the series, so that the step alone errs
    (define (off epsilon)
      (define E ((Hpendulum alpha (* epsilon beta)) (start 0.7)))
      (- (momentum ((C-inv alpha beta epsilon 6) (start 0.7)))
         (pendulum-frequency alpha (* epsilon beta) E)))
    (check-= (/ (log (/ (off 1/16) (off 1/32))) (log 2)) 2 0.1)))
