#lang mechanics
;; Exercise 5.6 (SICM 5.2.2): transposes and inverses of symplectic matrices
;; Checked: that both are symplectic
;; How: by what a matrix of unknowns misses, R = J − A J Aᵀ, from which theirs follow

;; If R is 0, so is what the transpose misses, for A J (J − Aᵀ J A) = R J A; and what the
;; inverse misses, for A (J − A⁻¹ J A⁻ᵀ) Aᵀ = −R.

(define J (symplectic-unit 2))
(define A (m:generate 4 4 (lambda (i j) (string->symbol (format "a_~a~a" i j)))))
(define R (symplectic-matrix? A))

(define right (verify-equal (* A J (symplectic-matrix? (transpose A))) (* R J A)))
right

;; Of the inverse: with B for it, A B = 1. Of two rows it is written out.
(define B (matrix-by-rows '(a b) '(c d)))
(define inverse
  (verify-equal (* B (symplectic-matrix? (/ B)) (transpose B)) (- (symplectic-matrix? B))))
inverse

;; Of two rows the determinant decides.
(define of-two (verify-equal (symplectic-matrix? B) (* (- 1 (determinant B)) (symplectic-unit 1))))
of-two

;; The slip: of four rows a determinant of 1 is not enough.
(define stretch (matrix-by-rows '(2 0 0 0) '(0 1 0 0) '(0 0 1 0) '(0 0 0 1/2)))
(define slip (verify-symplectic stretch))
(list (determinant stretch) (verdict-status slip))

(module+ test
  (require rackunit)
  (test-case "transposes and inverses miss what the matrix misses"
    (for ([v (list right inverse of-two)]) (check-pred proved? v)))
  (test-case "of four rows"
    (check-equal? (determinant stretch) 1)
    (check-pred refuted? slip)))
