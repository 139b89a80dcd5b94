#lang mechanics
;; Exercise 1.30 (SICM 1.7): orbits in a central potential
;; Checked: for which powers of the distance orbits close
;; How: the frequency of small oscillations about a circle; an orbit followed

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
(define powers '(-1 1 2 3 7))
(map oscillations-in-a-revolution powers)

;; Attempts: √(α + 2); and once in each revolution, whatever the force.
(define right
  (for/list ([alpha powers])
    (verify-equal (square (oscillations-in-a-revolution alpha)) (+ alpha 2))))
(define wrong
  (for/list ([alpha powers])
    (verify-equal (oscillations-in-a-revolution alpha) 1)))
(map verdict-status right)
(map verdict-status wrong)

;; An orbit in the potential energy r²/2 closes, with two oscillations in its period 2 π; one
;; in r does not.
(define ((L-plane U) (up t q v))
  (- (* 1/2 (square v)) (U (sqrt (square q)))))
(define start (up 0. (up 1. 0.) (up 0. 0.7)))
(define (orbit U)
  (evolve-trajectory (Lagrangian->state-derivative (L-plane U)) start :2pi #:tolerance 1e-12))
(define (opening trajectory)
  (sqrt (square (- (coordinate (trajectory :2pi)) (coordinate start)))))
(< (opening (orbit (power 1/2 2))) 1e-10)
(< (opening (orbit (power 1 1))) 1e-10)

(module+ test
  (require rackunit)
  (test-case "√(α + 2) oscillations in a revolution, one for Kepler's force alone"
    (for ([v right]) (check-pred proved? v))
    (check-equal? (map verdict-status wrong) '(proved refuted refuted refuted refuted)))
  (test-case "the oscillator's orbits close"
    (check-true (< (opening (orbit (power 1/2 2))) 1e-10))
    (check-true (> (opening (orbit (power 1 1))) 0.1))))
