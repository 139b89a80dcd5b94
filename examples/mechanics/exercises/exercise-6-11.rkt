#lang mechanics
;; Exercise 6.11 (SICM 6.5): Baker, Campbell and Hausdorff
;; Checked: the exponent of a product of exponentials, term by term
;; How: series of operators on any function, to the third order

;; exp(A) exp(B) = exp(A + B + [A, B]/2 + ([A, [A, B]] + [B, [B, A]])/12 + ⋯)

(define (any name) (literal-function name (Hamiltonian 1)))
(define-values (A B F) (values (Lie-derivative (any 'f)) (Lie-derivative (any 'g)) (any 'F)))
(define state (up 't 'q 'p))

(define Z2 (* 1/2 (commutator A B)))
(define Z3 (* 1/12 (+ (commutator A (commutator A B)) (commutator B (commutator B A)))))

(define Z (Baker-Campbell-Hausdorff A B))
(define second (verify-equal (((series:ref Z 2) F) state) ((Z2 F) state)))
second
(define third (verify-equal (((series:ref Z 3) F) state) ((Z3 F) state)))
third

;; The product to the second order, by itself: A²/2 + A B + B²/2 = (A + B)²/2 + Z₂.
(define product (series:ref (((exp A) ((exp B) F)) state) 2))
(define by-hand (verify-equal product (((+ (* 1/2 (expt (+ A B) 2)) Z2) F) state)))
by-hand

;; The slip: that exponents add.
(define slip (verify-equal product (((* 1/2 (expt (+ A B) 2)) F) state)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the terms of the second and third order"
    (for ([v (list second third by-hand)]) (check-pred proved? v)))
  (test-case "exponents that do not commute do not add"
    (check-pred refuted? slip)))
