#lang mechanics
;; Exercise 5.4 (SICM 5.2): canonical transformations form a group
;; Checked: compositions, the identity and inverses
;; How: verdicts on the brackets of particular ones and of the matrices of any

;; Show that a composition of canonical transformations is canonical, and an inverse.

(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))

(define product (verify-canonical (compose (F->CH p->r) (F->CH (lambda (s) (* 'a (ref s 1)))))
                                  polar))
product
(define unit (verify-canonical identity polar))
unit

;; In general: M and N keep J, M J Mᵀ = J, and so does M N. Of matrices of unknowns it is seen
;; with what they miss: it is M (what N misses) Mᵀ + (what M misses).
(define (unknown name)
  (m:generate 4 4 (lambda (i j) (string->symbol (format "~a_~a~a" name i j)))))
(define-values (M N) (values (unknown "m") (unknown "n")))
(define general
  (verify-equal (symplectic-matrix? (* M N))
                (+ (* M (symplectic-matrix? N) (transpose M)) (symplectic-matrix? M))))
general

;; The inverse of a matrix misses J by what the matrix does, seen through it: M (what M⁻¹ misses) Mᵀ
;; is − (what M misses). And one that is known in closed form:
(define any-matrix (matrix-by-rows '(a b) '(c d)))
(define inverse
  (verify-equal (* any-matrix (symplectic-matrix? (/ any-matrix)) (transpose any-matrix))
                (- (symplectic-matrix? any-matrix))))
inverse
(define back (verify-canonical (polar-canonical-inverse 'alpha) (up 't 'x 'p)))
(verdict-residual back)

;; The slip: the sum of two.
(define slip (verify-symplectic (+ (symplectic-unit 2) (identity-matrix 4))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "products and the identity"
    (for ([v (list product unit general)]) (check-pred proved? v)))
  (test-case "inverses"
    (check-pred proved? inverse)
    ;; its angle has a jump, on the negative half of the axis
    (check-equal? (verdict-reason back) 'kinks))
  (test-case "sums are not in it"
    (check-pred refuted? slip)))
