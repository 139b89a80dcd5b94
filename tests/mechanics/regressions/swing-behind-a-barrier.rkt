#lang racket/base
;; Turning points were looked for in steps that passed over a thin barrier, and over the pole of
;; a small angular momentum: the action was that of two swings.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt")

(define (double-well s) (+ (* 1/2 (square (ref s 2))) (square (- (square (ref s 1)) 1))))

;; The energy is a little less than the 1 of the barrier.
(test-case "a coordinate stays in its well"
  (define s (separate-Hamilton-Jacobi double-well (up 't 'x 'p)))
  (for ([below '(0.01 0.001 0.0001)])
    (define state (up 0 1.0 (sqrt (* 2 (- 1 below)))))
    (check-close (separation-actions s state) (action-of-orbit double-well state) 1e-8)))

;; Steps end at other places before and behind the barrier.
(test-case "wherever the coordinate starts"
  (define s (separate-Hamilton-Jacobi double-well (up 't 'x 'p)))
  (define (state-at x) (up 0 x (sqrt (* 2 (- 0.9999 (double-well (up 0 x 0)))))))
  (define action (action-of-orbit double-well (state-at 1.0)))
  (for ([x '(0.8 0.9 1.1 1.2 1.25 1.3)])
    (check-close (separation-actions s (state-at x)) action 1e-8)))

(test-case "a radius stays positive"
  (define (H s)
    (+ (* 1/2 (square (ref s 2 0))) (* 1/2 (square (/ (ref s 2 1) (ref s 1 0))))
       (* 1/2 (square (ref s 1 0)))))
  (define s (separate-Hamilton-Jacobi H (up 't (up 'r 'phi) (down 'p_r 'p_phi))))
  (for ([L '(0.1 0.01 0.001)])
    (define state (up 0 (up 1.0 0.0) (down 0.3 L)))
    (check-close (ref (separation-actions s state) 0) (/ (- (H state) L) 2) 1e-10)))

(test-case "a radius without angular momentum turns at the centre"
  (define (H s)
    (+ (* 1/2 (square (ref s 2 0))) (* 1/2 (square (/ (ref s 2 1) (ref s 1 0))))
       (/ -1 (ref s 1 0))))
  (define s (separate-Hamilton-Jacobi H (up 't (up 'r 'phi) (down 'p_r 'p_phi))))
  (define state (up 0 (up 1.0 0.0) (down 0.3 0)))
  (check-close (ref (separation-actions s state) 0) (/ 1 (sqrt (* -2 (H state)))) 1e-8))
