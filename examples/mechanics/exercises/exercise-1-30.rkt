#lang mechanics
;; Exercise 1.30 (SICM 1.7): orbits in a central potential
;; Checked: for which powers of the distance orbits close
;; How: the frequency of small oscillations about a circle; orbits followed

;; A particle moves in the potential energy β r^α, α and β of one sign.  How many times does
;; its distance oscillate in a revolution, if the orbit is nearly circular?

;; With the angular momentum p the radius moves by itself.
(define ((L-radial m p U) (up t r rdot))
  (- (* 1/2 m (square rdot)) (/ (square p) (* 2 m (square r))) (U r)))
(define ((power beta alpha) r) (* beta (expt r alpha)))

;; A circle of radius R, gone round at the rate n, balances when α β = m n² R^(2 − α).
(define (oscillations-in-a-revolution alpha)
  (define p (* 'm 'n (square 'R)))
  (define beta (/ (* 'm (square 'n) (expt 'R (- 2 alpha))) alpha))
  (/ (car (small-oscillation-frequencies (L-radial 'm p (power beta alpha)) 'R)) 'n))

(assume '(> n 0) '(> R 0) '(> m 0))
(define number (oscillations-in-a-revolution 'alpha))
number

;; Attempts: √(α + 2); and once in each revolution, so that every orbit closes.
(define right (verify-equal number (sqrt (+ 'alpha 2))))
(define wrong (verify-equal (square number) 1))
right
wrong

;; The slip's condition names Kepler's force.  For others, orbits near a circle close if the
;; number is a fraction:
(map oscillations-in-a-revolution '(-1 1 2 7))

;; The same from motions that are followed: the angle from one largest distance to the next, on
;; an orbit that starts a little slower than on the circle.
(define ((L-plane U) (up t q v))
  (- (* 1/2 (square v)) (U (sqrt (square q)))))
(define (counted alpha)
  (define about (/ :2pi (sqrt (+ alpha 2))))
  (define orbit
    (evolve-trajectory (Lagrangian->state-derivative (L-plane (power (/ 1. alpha) alpha)))
                       (up 0. (up 1. 0.) (up 0. 0.99)) (* 1.3 about) #:tolerance 1e-12))
  (define (moving-away t) (dot-product (coordinate (orbit t)) (velocity (orbit t))))
  (match (coordinate (orbit (find-root moving-away (* 0.8 about) (* 1.2 about))))
    [(up x y) (/ :2pi (if (< y 0) (+ (atan y x) :2pi) (atan y x)))]))
(define (near? a b) (< (abs (- a b)) 1e-3))
(for/list ([alpha '(1 2 7)]) (near? (counted alpha) (sqrt (+ alpha 2))))
(for/list ([alpha '(1 2 7)]) (near? (counted alpha) 1))

(module+ test
  (require rackunit)
  (test-case "√(α + 2) oscillations in a revolution, one for Kepler's force alone"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-equal? (map expression (verdict-conditions wrong)) '((= alpha -1))))
  (test-case "motions show as many"
    (for ([alpha '(1 2 7)])
      (check-= (counted alpha) (sqrt (+ alpha 2.0)) 1e-3))))
