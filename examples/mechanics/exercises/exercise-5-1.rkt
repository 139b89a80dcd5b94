#lang mechanics
;; Exercise 5.1 (SICM 5.1): a Galilean transformation
;; Checked: the new Hamiltonian of a free particle, H∘C + K
;; How: the residual of both motions, and a verdict for any potential

;; A frame moves with the velocity v along x. Extend x = x' + v t to phase space, and find the
;; Hamiltonian that the motion has in it.

(define (moving state) (+ (coordinate state) (* 'v (time state))))
(define V (literal-function 'V))
(define (H state) (+ (/ (square (momentum state)) (* 2 'm)) (V (coordinate state))))
(define state (up 't 'x 'p))

;; The momentum stays, and the Hamiltonian gets −p v: p is m times the old velocity.
(define C (F->CH moving))
(C state)
(define attempt (+ (compose H C) (F->K moving)))
(attempt state)
(define right (verify-canonical C H attempt state))
right

;; The slip: H∘C alone, as if the frame stood still.
(define slip (verify-canonical C H (compose H C) state))
(verdict-status slip)
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "with the term of the moving frame"
    (check-pred proved? right)
    (check-pred proved? (verify-equal ((F->K moving) state) (* -1 'p 'v))))
  (test-case "without it the old velocity is taken for the new one"
    (check-pred refuted? slip)
    (check-equal? (verdict-conditions slip) '((= v 0)))
    (check-pred proved? (verify-equal (verdict-residual slip) (up 0 (- 'v) 0)))))
