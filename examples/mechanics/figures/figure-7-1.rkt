#lang mechanics
;; More terms of a perturbative solution  (SICM 7.2, Figure 7.1)
;;
;; The pendulum as a perturbed rotor, after one step of perturbation theory: the Lie series that
;; takes old states to new ones and back is summed up to the order 1, red, 2, 3 and 4.  The sums
;; seem to converge.  They do not begin in one point: cut off, the series and that with −ε are not
;; quite inverse to each other.

(require mechanics/plot mechanics/book "rotor.rkt")

(define orders '(1 2 3 4))
(define (motion order) ((first-step order) (start 0.7)))

(define picture (plane 0.25 0.8))
(for ([n orders] [color '(red black blue green)])
  (draw-turn picture (motion n) #:color color))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-7-1.png"))

(module+ test
  (require rackunit)
  (define (heights theta) (for/list ([n orders]) (momentum (state-at (motion n) theta))))
  (test-case "at θ = −π the order grows from the top to the bottom"
    (check-true (apply > (heights :-pi))))
  (test-case "at θ = 0 the fourth is between the second and the third"
    (define middle (heights 0.))
    (check-true (< (cadr middle) (cadddr middle) (caddr middle))))
  (test-case "turns of higher orders take longer, and by less each time"
    (define times (for/list ([n orders]) (turn-time (motion n))))
    (define steps (for/list ([a times] [b (cdr times)]) (- b a)))
    (check-true (apply > steps))
    (check-true (> (apply min steps) 0)))
  ;; C(ε) misses the flow by r εⁿ⁺¹ and its inverse C(−ε) by r (−ε)ⁿ⁺¹: for even n they cancel.
  (test-case "the start is missed by the next order that is even: with ε halved"
    (for ([n orders])
      (define (missed epsilon)
        (define s
          ((C alpha beta epsilon n) ((C-inv alpha beta epsilon n) (up 0. 1. 0.7))))
        (+ (abs (- (coordinate s) 1.)) (abs (- (momentum s) 0.7))))
      (define ratio (/ (missed 1/32) (missed 1/64)))
      (check-= (/ (log ratio) (log 2)) (if (even? n) (+ n 2) (+ n 1)) 0.2)))
  (test-case "numbers: the momentum of the rotor, by the first and the second order"
    (check-= (momentum ((C-inv alpha beta 1 1) (start 0.7))) 0.55714285714286 1e-13)
    (check-= (momentum ((C-inv alpha beta 1 2) (start 0.7))) 0.54256559766764 1e-13)))
