#lang mechanics
;; A perturbative solution that does not converge  (SICM 7.2, Figure 7.3)
;;
;; As figure 7.1, from p = 0.55, below the separatrix: the pendulum swings, the rotor that it is
;; told by turns.  Near θ = ±π the curves have loops, which grow with the order.

(require mechanics/plot mechanics/book "rotor.rkt")

(define orders '(1 2 3 4))
;; One turn of the rotor, drawn out from there
(define (momentum-of-rotor order) (momentum ((C-inv alpha beta 1 order) (start 0.55))))

(define picture (plane -0.5 0.8))
(for ([n orders] [color '(red black blue green)])
  (draw-turn picture ((first-step n) (start 0.55)) #:color color
             #:duration (/ (* alpha :2pi) (momentum-of-rotor n))))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-3.png"))

(module+ test
  (require rackunit)
  ;; How far a curve turns back in θ
  (define (loops n)
    (define C-n (C alpha beta 1 n))
    (define p (momentum-of-rotor n))
    (define angles
      (for/list ([k (in-range -64 65)]) (coordinate (C-n (up 0. (* k (/ pi 64)) p)))))
    (for/sum ([a angles] [b (cdr angles)]) (max 0. (- a b))))
  (test-case "loops grow with the order, from none"
    (define sizes (map loops '(1 2 3 4 5 6)))
    (check-= (car sizes) 0 1e-12)
    (check-true (apply < sizes))
    (check-true (> (list-ref sizes 5) 2)))
  (test-case "while the pendulum itself only swings"
    (define swing (truth (start 0.55)))
    (define angles (for/list ([t 60]) (coordinate (swing (* 1. t)))))
    (define turn (acos (- 1 (/ (square 0.55) (* 2 alpha beta)))))
    (check-true (< (apply max (map abs angles)) (+ turn 1e-9)))
    (check-true (< turn pi))))
