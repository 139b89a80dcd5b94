#lang mechanics
;; Exercise 1.43 (SICM 1.12): a pendulum of a given period, three times
;; Checked: the amplitude that belongs to a period, and the motion
;; How: an elliptic integral, an integration, and a path of least action

;; A pendulum with g = 9.8 and l = 1 is to swing with the period 2.14 s.  How far?
;; Small swings, whatever their size, would take 2 π √(l/g).

(require mechanics/book)

(define-values (g l period) (values 9.8 1. 2.14))

;; First, by a formula: T = 4 √(l/g) K(sin ½ θ₀).
(define (period-of amplitude)
  (* 4 (sqrt (/ l g)) (first-elliptic-integral (sin (/ amplitude 2)))))
(define amplitude (find-root (lambda (a) (- (period-of a) period)) 0.5 1.5))

;; Second, by following the motion: after a quarter of the period it hangs straight down.
(define (angle amplitude t)
  (coordinate ((state-advancer Lagrangian->state-derivative (L-pendulum g 1. l))
               (up 0. amplitude 0.) t 1e-12)))
(define (same? a b tolerance) (< (abs (- a b)) tolerance))
(same? (angle amplitude (/ period 4)) 0 1e-9)
(same? (angle amplitude (/ period 2)) (- amplitude) 1e-9)

;; Third, as the path of least action from there to the bottom, in a quarter of the period.
(define path (find-path (L-pendulum g 1. l) 0. amplitude (/ period 4) 0. 4))
(same? (path (/ period 8)) (angle amplitude (/ period 8)) 1e-4)

;; A slip: that amplitude with the period of small swings.
(define small (* 2 :pi (sqrt (/ l g))))
(same? (angle amplitude (/ small 4)) 0 1e-9)

;; The angle that remains, over the velocity at the bottom, is the time that is missing.
(define missing (- (/ period 4) (/ small 4)))
(define speed-at-bottom (sqrt (* 2 (/ g l) (- 1 (cos amplitude)))))
(same? (/ (angle amplitude (/ small 4)) speed-at-bottom) missing 1e-4)

(module+ test
  (require rackunit)
  (test-case "the period of the amplitude 1"
    (check-= (period-of 1.) 2.140228719018093 1e-12))
  (test-case "formula, motion and path agree"
    (check-= (angle amplitude (/ period 4)) 0 1e-9)
    (check-= (angle amplitude (/ period 2)) (- amplitude) 1e-9)
    (check-= (path (/ period 8)) (angle amplitude (/ period 8)) 1e-4))
  (test-case "the period of small swings is too short"
    (check-true (> (angle amplitude (/ small 4)) 0.05))
    (check-= (/ (angle amplitude (/ small 4)) speed-at-bottom) missing 1e-4)))
