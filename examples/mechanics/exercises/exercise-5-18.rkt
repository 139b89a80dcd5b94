#lang mechanics
;; Exercise 5.18 (SICM 5.5): Lorentz transformations in extended phase space
;; Checked: that they are canonical there, and what they keep
;; How: point transformations of place and time together; verdicts

;; A boost with the velocity v, of x and t: to the frame at rest from the moving one.
(define gamma (/ 1 (sqrt (- 1 (square (/ 'v 'c))))))
(define (boost s)
  (define-values (t x) (values (ref s 1 0) (ref s 1 1)))
  (up (* gamma (+ t (/ (* 'v x) (square 'c))))
      (* gamma (+ x (* 'v t)))))
(define C (F->CH boost))
(define state (up 's (up 't 'x) (down 'p_t 'p)))
(define canonical (verify-canonical C state))
canonical

;; p_t is minus the energy: energy and momentum transform by the same boost.
(define image (C state))
(define energy-gained
  (verify-equal (- (ref image 2 0)) (* gamma (+ (- 'p_t) (* 'v 'p)))))
energy-gained

;; A Hamiltonian in which all frames are alike: (c²p² − p_t²)/(2 m c²), minus half the energy of
;; rest.
(define (H-e s)
  (define-values (p_t p) (values (ref s 2 0) (ref s 2 1)))
  (/ (- (square (* 'c p)) (square p_t)) (* 2 'm (square 'c))))
(define right (verify-equal (H-e image) (H-e state)))
right

;; The slip: Galileo's boost, which leaves the time alone, with the same Hamiltonian.
(define (slip-boost s) (up (ref s 1 0) (+ (ref s 1 1) (* 'v (ref s 1 0)))))
(define slip (verify-equal (H-e ((F->CH slip-boost) state)) (H-e state)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "boosts are canonical, and keep the Hamiltonian"
    (for ([v (list canonical energy-gained right)]) (check-pred proved? v)))
  (test-case "Galileo's is canonical, and does not"
    (check-pred proved? (verify-canonical (F->CH slip-boost) state))
    (check-pred refuted? slip)))
