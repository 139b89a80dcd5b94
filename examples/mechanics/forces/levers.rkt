#lang mechanics
;; Equilibrium by virtual work: what would be done in a small displacement is zero.
;; No force in a hinge, a pivot or a rod is ever mentioned.

;; A lever with arms a and b, loaded with weights A and B: heights as functions of its angle.
(define ((lever a b) t phi) (up (* -1 a (sin phi)) (* b (sin phi))))
(define ((loads A B) t heights v) (up (* -1 A) (* -1 B)))
(define lever-work ((static-equilibrium (lever 'a 'b) (loads 'A 'B)) 't 'phi))
(prove-zero lever-work)

;; Two rods, hinged to each other, hang from a point; a horizontal force P pulls at the
;; end.  Angles are from the vertical.  Forces act at the two middles and the end.
(define ((rods l1 l2) t (up alpha beta))
  (define (along angle) (up (sin angle) (* -1 (cos angle))))
  (define hinge (* l1 (along alpha)))
  (up (* 1/2 hinge)
      (+ hinge (* 1/2 l2 (along beta)))
      (+ hinge (* l2 (along beta)))))
(define ((pulled m1 m2 g P) t r v)
  (up (up 0 (* -1 m1 g)) (up 0 (* -1 m2 g)) (up P 0)))
(define work
  (static-equilibrium (rods 'l_1 'l_2) (pulled 'm_1 'm_2 'g 'P)))
(work 't (up 'alpha 'beta))

;; From each component, the tangent of an angle.
(define angles
  (up (atan (/ (* 2 'P) (* (+ 'm_1 (* 2 'm_2)) 'g)))
      (atan (/ (* 2 'P) (* 'm_2 'g)))))
(prove-zero (work 't angles))

(module+ test
  (require rackunit)
  (test-case "the lever is in equilibrium when a A = b B"
    (check-true (refuted? (prove-zero lever-work)))
    (check-true (proved? (prove-zero (substitute lever-work 'A (/ (* 'b 'B) 'a))))))
  (test-case "the rods are at these angles, and at no others nearby"
    (check-true (proved? (prove-zero (work 't angles))))
    (check-true (refuted? (prove-zero (work 't (up (ref angles 0) 0))))))
  (test-case "there the potential energy is least"
    (define (energy q)
      (define r ((rods 1.0 2.0) 0.0 q))
      (- (+ (* 3.0 9.8 (ref r 0 1)) (* 2.0 9.8 (ref r 1 1))) (* 5.0 (ref r 2 0))))
    (define at
      (substitute angles 'm_1 3.0 'm_2 2.0 'g 9.8 'P 5.0))
    (for* ([da '(-0.1 0 0.1)] [db '(-0.1 0 0.1)] #:unless (= 0 da db))
      (check-true (< (energy at) (energy (+ at (up da db))))))))
