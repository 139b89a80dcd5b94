#lang mechanics
;; Exercise 5.6 (SICM 5.2): symplectic matrices
;; Checked: that transposes, inverses and determinants are as they should be
;; How: verdicts for matrices of two rows of unknowns, with their condition

;; A matrix of two rows and columns is symplectic if its determinant is 1.

(define M (matrix-by-rows '(a b) '(c d)))
(define plain (verify-symplectic M))
plain
(define right (verify-equal (symplectic-matrix? M) (* (- 1 (determinant M)) (symplectic-unit 1))))
right

;; Its transpose misses J by the same.
(define transposed (verify-equal (symplectic-matrix? M) (symplectic-matrix? (transpose M))))
transposed

;; The slip: of four rows a determinant of 1 is not enough.
(define stretch (matrix-by-rows '(2 0 0 0) '(0 1 0 0) '(0 0 1 0) '(0 0 0 1/2)))
(define slip (verify-symplectic stretch))
(list (determinant stretch) (verdict-status slip))

(module+ test
  (require rackunit)
  (test-case "of two rows"
    (for ([v (list right transposed)]) (check-pred proved? v))
    (check-pred refuted? plain))
  (test-case "of four"
    (check-equal? (determinant stretch) 1)
    (check-pred refuted? slip)))
