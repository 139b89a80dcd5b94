#lang mechanics
;; A second step of perturbation theory  (SICM 7.2.1, Figure 7.5)
;;
;; The pendulum from p = 0.7 by two steps, which remove all terms of the orders ε and ε² from its
;; Hamiltonian, and, blue, the pendulum itself, for a time of 10.  At first the two agree much
;; better than those of figure 7.2.

(require mechanics/plot mechanics/book "rotor.rkt" "refined.rkt")

(define (free p epsilon) (/ (square p) (* 2 alpha)))
(define told ((two-steps W-secular free) (start 0.7)))
(define true (truth (start 0.7)))

(define picture (plane 0.25 0.8))
(draw-points picture true 10. 0.05 #:color 'blue)
(draw-points picture told 10. 0.05)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-5.png"))

(module+ test
  (require rackunit)
  (define state (up 't 'theta 'p))
  (test-case "(7.27): the second generator removes what the first has left"
    (define left
      (series:ref (((exp (* 'e (Lie-derivative (W 'alpha 'beta))))
                    (H-pendulum-series 'alpha 'beta 'e))
                   state)
                  2))
    (define removed
      (((Lie-derivative (W-secular 'alpha 'beta)) (H0 'alpha)) state))
    (check-pred proved? (prove-zero (+ removed (/ left (square 'e)))))
    ;; as printed it doubles what turns
    (define printed (- (W-secular 'alpha 'beta) (* 2 (W-periodic 'alpha 'beta))))
    (check-pred refuted? (prove-zero (+ (((Lie-derivative printed) (H0 'alpha)) state)
                                        (/ left (square 'e))))))
  ;; errors of the angle
  (define (misses motion)
    (for/list ([t '(1. 2. 3. 4. 5. 6.)])
      (abs ((principal-value :pi) (- (coordinate (motion t)) (coordinate (true t)))))))
  (test-case "at first it is better than one step by far"
    (for ([two (misses told)] [one (misses ((first-step 4) (start 0.7)))])
      (check-true (< (* 3 two) one))))
  (test-case "there is no third order: what W makes of the second one is zero"
    (check-pred proved?
                (prove-zero (((expt (Lie-derivative (W 'alpha 'beta)) 2) (H1 'beta)) state))))
  (test-case "the angle is told up to the fourth order: with ε halved"
    (define (off epsilon)
      (define s (((two-steps W-secular free #:epsilon epsilon) (start 0.7)) 2.))
      (define s* (((pendulum-advance alpha (* epsilon beta)) (start 0.7)) 2.))
      (- (coordinate s) (coordinate s*)))
    (check-= (/ (log (/ (off 1/8) (off 1/16))) (log 2)) 4 0.3)))
