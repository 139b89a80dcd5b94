#lang mechanics
;; Exercise 2.20 (SICM 2.14): free rigid bodies
;; Checked: the curves of the angular momentum on the body, and those that end at the middle axis
;; How: what is conserved; a path with tanh and sech in Euler's equations; motions

;; Which paths of the angular momentum on the principal axes go to the rotation about the middle
;; one, and never come back?  (The picture is Figure 2.3, among the figures.)

;; The paths are where the ellipsoid of the energy meets the sphere of |L|.
(define state (up 't (up 'q_0 'q_1 'q_2 'q_3) (up 'a 'b 'c)))
(define (rate f) (* ((D f) state) ((qw-sysder 'A 'B 'C) state)))
(define on-body (qw-state->L-body 'A 'B 'C))
(define (energy s) ((T-body 'A 'B 'C) (velocity s)))
(define curves (prove-zero (up (rate energy) (rate (compose square on-body)))))
curves

;; An attempt at the separatrix: ω_b = w tanh(s t), the others fall off as 1/cosh.
(define (sech t) (/ 1 (cosh t)))
(define ((separatrix A B C s) t)
  (up (* 'w (sqrt (/ (* B (- C B)) (* A (- C A)))) (sech (* s t)))
      (* 'w (tanh (* s t)))
      (* 'w (sqrt (/ (* B (- B A)) (* C (- C A)))) (sech (* s t)))))
(define (growth A B C) (* 'w (sqrt (/ (* (- B A) (- C B)) (* A C)))))
(define (verdict-for A B C sign)
  (prove-zero ((Euler-equations A B C) (separatrix A B C (* sign (growth A B C))))))
(define right (list (verdict-for 3 4 6 1) (verdict-for 2 5 6 1)))
(map verdict-status right)

;; A slip in the sign: then it is a motion seen in a mirror.
(define wrong (verdict-for 3 4 6 -1))
(verdict-status wrong)

;; In numbers: a start on it goes to the middle axis, one beside it comes back.
(define-values (A B C) (values 1. (sqrt 2.) 2.))
(define (on-it a) (up 0 (up 1 0 0 0) (up a 0. (* a (sqrt (/ (* A (- B A)) (* C (- C B))))))))
(define (beside a) (up 0 (up 1 0 0 0) (up a 0. (* 1.001 (ref (on-it a) 2 2)))))
(define (fastest-share start t)
  (define w (velocity ((state-advancer qw-sysder A B C) start t 1e-13)))
  (/ (abs (ref w 1)) (sqrt (square w))))
(list (fastest-share (on-it 0.5) 40) (fastest-share (beside 0.5) 80))

(module+ test
  (require rackunit)
  (test-case "energy and length are kept on the body"
    (check-pred proved? curves))
  (test-case "the separatrix solves Euler's equations, its mirror image does not"
    (for ([v right]) (check-pred proved? v))
    (check-pred refuted? wrong))
  (test-case "both constants are those of the middle axis: L² = 2 E B"
    (define w (velocity (on-it 0.5)))
    (check-= (square ((L-body A B C) w)) (* 2 B ((T-body A B C) w)) 1e-14))
  (test-case "it gets there; its neighbour is seen elsewhere again"
    (check-true (> (fastest-share (on-it 0.5) 40) 0.9999))
    (check-true (< (apply min (for/list ([t (in-range 40 140 5)]) (fastest-share (beside 0.5) t)))
                   0.9))))
