#lang mechanics
;; Exercise 1.24 (SICM 1.6.2): the tension of a pendulum
;; Checked: the force of the rod at any place and speed
;; How: against constraint-forces, on states that keep the rod's length

;; With which tension does the rod of a planar pendulum hold its bob?

(define ((L-falling m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define (rod t (up x y))
  (- (sqrt (+ (square x) (square y))) 'l))

(define (from-angle local)
  (define theta (coordinate local))
  (up (* 'l (sin theta)) (* -1 'l (cos theta))))
(define state ((F->C from-angle) (up 't 'theta 'thetadot)))

;; The force of the rod as a down tuple.
(assume '(> l 0))
(define force ((constraint-forces (L-falling 'm 'g) (holonomic rod)) state))
force

;; It points from the bob to the pivot with the size of the tension.
(define (inward tension)
  (* -1 tension (down (sin 'theta) (* -1 (cos 'theta)))))
(define right
  (verify-equal force (inward (* 'm (+ (* 'g (cos 'theta)) (* 'l (square 'thetadot)))))))
right

;; A bob at rest gets what balances its weight along the rod; a moving one needs more.
(define wrong (verify-equal force (inward (* 'm 'g (cos 'theta)))))
wrong
(prove-zero (substitute (verdict-residual wrong) 'thetadot 0))

(module+ test
  (require rackunit)
  (test-case "weight and centripetal force"
    (check-pred proved? right))
  (test-case "the weight alone is right for a bob at rest"
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (substitute (verdict-residual wrong) 'thetadot 0)))))
