#lang mechanics
;; Exercise 1.32 (SICM 1.8.2): energy where a constraint moves
;; Checked: how the energy of a driven pendulum differs from T + V, and what changes it
;; How: formulas compared at a state

;; The pivot of a pendulum is moved, y_s(t).  By how much does the energy that the Lagrangian
;; defines differ from T + V?  At which rate does T + V change?

(require mechanics/book)

(define y_s (literal-function 'y_s))
(define parameters (list 'm 'l 'g y_s))
(define L (apply L-pend parameters))
(define T+V (+ (apply T-pend parameters) (apply V-pend parameters)))
(define state (up 't 'theta 'thetadot))

;; The difference is the pivot's velocity times the upward momentum of the bob.
(define pivot-velocity ((D y_s) 't))
(define bob-velocity (+ pivot-velocity (* 'l 'thetadot (sin 'theta))))
(define difference (- ((Lagrangian->energy L) state) (T+V state)))
(define right (verify-equal difference (* -1 'm pivot-velocity bob-velocity)))
right

;; A slip: they are equal, as they would be with the pivot at rest.
(define wrong (prove-zero difference))
wrong

;; T + V changes by the work of the pivot, which pushes the bob with m (g + its acceleration).
(define (rate Q) ((rate-of-change L Q) state))
(define (upward-velocity local)
  (+ ((D y_s) (time local)) (* 'l (velocity local) (sin (coordinate local)))))
(define work
  (verify-equal (rate T+V) (* 'm (+ 'g (rate upward-velocity)) pivot-velocity)))
work

(module+ test
  (require rackunit)
  (test-case "the difference, and the work"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? work))
  (test-case "with the pivot at rest the energy is T + V"
    (check-pred proved? (prove-zero (substitute difference pivot-velocity 0)))))
