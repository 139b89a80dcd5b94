#lang mechanics
;; Exercise 1.33 (SICM 1.8.2): falling off a log
;; Checked: where a particle leaves a cylinder, and with which angular velocity
;; How: the force of the constraint, with the speed that the conserved energy gives

;; A particle slides, without friction, down from the top of a level log of radius R, starting
;; with next to no speed.  Where does it leave the log, and how fast is it then?

(define ((L-falling m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define (on-the-log t (up x y))
  (- (sqrt (+ (square x) (square y))) 'R))

(assume '(> R 0))
(define (from-angle local)
  (up (* 'R (sin (coordinate local))) (* 'R (cos (coordinate local)))))
(define state ((F->C from-angle) (up 't 'theta 'thetadot)))

;; The log can push only: the particle leaves where its push would change sign.
(define push
  (ref ((constrained-accelerations (L-falling 'm 'g) (holonomic on-the-log)) state) 1))
(simplify push)

;; By hand: the weight's part along the radius, less what turns the velocity.  The energy gives
;; the speed, ½ R θ̇² = g (1 − cos θ).
(define (push-by-hand cosine thetadot-squared)
  (- (* 'm 'g cosine) (* 'm 'R thetadot-squared)))
(verify-equal push (push-by-hand (cos 'theta) (square 'thetadot)))
(define (push-at cosine)
  (push-by-hand cosine (* 2 (/ 'g 'R) (- 1 cosine))))

;; An attempt: it leaves at two thirds of the height.  Another one: at half of it.
(define right (prove-zero (push-at 2/3)))
(define wrong (prove-zero (push-at 1/2)))
right
wrong

;; At half the height the log would have to pull.  The angular velocity at two thirds,
;; squared:
(* 2 (/ 'g 'R) (- 1 2/3))

(module+ test
  (require rackunit)
  (test-case "the push, and where it ends"
    (check-pred proved? (verify-equal push (push-by-hand (cos 'theta) (square 'thetadot))))
    (check-pred proved? right))
  (test-case "at half the height the log would pull"
    (check-pred refuted? wrong)
    (check-equal? (expression (verdict-residual wrong)) '(* -1/2 g m))))
