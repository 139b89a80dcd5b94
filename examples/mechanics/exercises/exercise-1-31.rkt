#lang mechanics
;; Exercise 1.31 (SICM 1.7): Foucault's pendulum followed
;; Checked: the rate at which the plane of the swings turns
;; How: a solution by formula, and the evolution compared with it

;; For small swings Foucault's pendulum has the Lagrangian below, in level coordinates x to the
;; south and y to the east; w is Ω cos β, the part of the earth's turning about the vertical.
;; How fast, and which way, does the plane of the swings turn?

(define ((L-Foucault m g l w) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (* m w (- (* x vy) (* y vx)))
     (* -1/2 m (/ g l) (+ (square x) (square y)))))

;; Swings of frequency n in a plane that turns at some rate.
(define ((swings n rate) t)
  (* (cos (* n t)) (up (cos (* rate t)) (sin (* rate t)))))
(define L (L-Foucault 'm (* 'l (- (square 'n) (square 'w))) 'l 'w))
(define right (verify-solution L (swings 'n (- 'w))))
(define wrong (verify-solution L (swings 'n 'w)))
right
(verdict-status wrong)

;; In numbers, with an earth that turns fast: the swings should stay
;; where the formula has them.
(define-values (w n) (values 0.01 1.))
(define derivative (Lagrangian->state-derivative (L-Foucault 1. (- (square n) (square w)) 1. w)))
(define swing
  (evolve-trajectory derivative ((Gamma (swings n (- w))) 0.) 100. #:tolerance 1e-12))
(define (distance rate)
  (for/fold ([worst 0]) ([t (in-range 0. 100. 0.5)])
    (max worst (sqrt (square (- (coordinate (swing t)) ((swings n rate) t)))))))
(< (distance (- w)) 1e-9)
(< (distance w) 1e-9)

(module+ test
  (require rackunit)
  (test-case "the plane turns backwards at the rate Ω cos β"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-true (< (distance (- w)) 1e-9))
    (check-true (> (distance w) 1))))
