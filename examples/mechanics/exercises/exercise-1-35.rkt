#lang mechanics
;; Exercise 1.35 (SICM 1.8.4): the equations of the restricted three-body problem
;; Checked: the equations on axes that turn with the two bodies
;; How: against the residuals of the Lagrangian

;; Derive the equations of motion of the third body, and say which terms are the forces of
;; Coriolis and the centrifugal ones.

(require mechanics/book)

(define L (LR3B1 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1))
(define local (up 't (up 'x 'y) (up 'vx 'vy) (up 'ax 'ay)))
(define residual ((Euler-Lagrange-operator L) local))

(define attraction
  (let ([r_0 (sqrt (+ (square (+ 'x 'a_0)) (square 'y)))]
        [r_1 (sqrt (+ (square (- 'x 'a_1)) (square 'y)))])
    (down (- (+ (* 'GM_0 (/ (+ 'x 'a_0) (cube r_0))) (* 'GM_1 (/ (- 'x 'a_1) (cube r_1)))))
          (- (+ (* 'GM_0 (/ 'y (cube r_0))) (* 'GM_1 (/ 'y (cube r_1))))))))
(define centrifugal (* (square 'Omega) (down 'x 'y)))
(define Coriolis (* 2 'Omega (down 'vy (* -1 'vx))))

;; Mass times acceleration is the sum of the forces.
(define (equations . forces)
  (* 'm (- (down 'ax 'ay) (apply + forces))))
(define right (verify-equal residual (equations attraction centrifugal Coriolis)))
right

;; With half the force of Coriolis, as from the angular momentum alone, the other half is
;; left over.
(define wrong (verify-equal residual (equations attraction centrifugal (* 1/2 Coriolis))))
wrong

(module+ test
  (require rackunit)
  (test-case "gravity, centrifugal force, force of Coriolis"
    (check-pred proved? right))
  (test-case "half of the force of Coriolis is missing"
    (check-pred refuted? wrong)
    (check-equal? (expression (verdict-residual wrong))
                  '(down (* -1 Omega m vy) (* Omega m vx)))))
