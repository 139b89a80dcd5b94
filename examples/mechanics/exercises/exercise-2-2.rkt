#lang mechanics
;; Exercise 2.2 (SICM 2.3): Steiner's theorem
;; Checked: the moment of inertia about a line beside the centre of mass
;; How: against the sum over points; with the tensor of the library

;; The moment of inertia of a body about a line through its centre of mass is I.  What is it
;; about a line parallel to that, at the distance R?

;; Points m_1, m_2 and m_3, the last one where the centre of mass is at the origin; lines along z.
(define masses '(m_1 m_2 m_3))
(define two (list (up 'x_1 'y_1 'z_1) (up 'x_2 'y_2 'z_2)))
(define third (/ (+ (* 'm_1 (car two)) (* 'm_2 (cadr two))) (- 'm_3)))
(define points (append two (list third)))

(define (about-z shift)
  (matrix-ref (inertia-tensor masses (for/list ([p points]) (+ p shift))) 2 2))
(define I (about-z (up 0 0 0)))
(define M (+ 'm_1 'm_2 'm_3))
(define shifted (about-z (up (* 'R (cos 'alpha)) (* 'R (sin 'alpha)) 0)))

(define attempt (+ I (* M (square 'R))))
(define right (verify-equal shifted attempt))
right

;; A slip: the masses as if they were one at the new line already, with I left out.
(define wrong (verify-equal shifted (* M (square 'R))))
(verdict-status wrong)

;; From a point that is not the centre of mass it is not so: there is a term with the place of
;; the centre, twice.
(define off-center (inertia-tensor '(m) (list (up 'a 0 0))))
(define further (inertia-tensor '(m) (list (up (+ 'a 'R) 0 0))))
(define not-from-there
  (verify-equal (matrix-ref further 2 2)
                (+ (matrix-ref off-center 2 2) (* 'm (square 'R)))))
not-from-there

;; The tensor follows the same rule.
(define d (up 'a 'b 'c))
(define tensor
  (verify-equal (inertia-tensor masses (for/list ([p points]) (+ p d)))
                (parallel-axes (inertia-tensor masses points) M d)))
tensor

(module+ test
  (require rackunit)
  (test-case "about a parallel line, at any distance and in any direction"
    (check-pred proved? right)
    (check-pred proved? tensor))
  (test-case "the slips"
    (check-pred refuted? wrong)
    (check-pred refuted? not-from-there)
    (check-equal? (expression (verdict-residual not-from-there)) '(* 2 R a m))))
