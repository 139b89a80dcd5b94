#lang racket/base
;; SICM 5.3, Invariants of Canonical Transformations (pp. 357-364).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define (state-named mark)
  (define (name i) (string->symbol (format "~a~a" mark i)))
  (up 0 (up (name 1) (name 2)) (down (name 3) (name 4))))

(define place (up 't (up 'r 'phi) (down 'p_r 'p_phi)))

;; p. 361: ω of two increments is that of their images.
(test-case "the symplectic form is kept"
  (define C (F->CH p->r))
  (define DC ((D C) place))
  (define-values (a b) (values (state-named 'a) (state-named 'b)))
  (check-identity (omega (* DC a) (* DC b)) (omega a b))
  (check-prints (omega (up 0 'dq_1 'dp_1) (up 0 'dq_2 'dp_2)) '(- (* dp_2 dq_1) (* dp_1 dq_2))))

(test-case "with any point transformation"
  (define V (literal-function 'f (-> (X Real Real) Real)))
  (define W (literal-function 'g (-> (X Real Real) Real)))
  (define (F state)
    (define q (coordinate state))
    (up (V (ref q 0) (ref q 1)) (W (ref q 0) (ref q 1))))
  (define DC ((D (F->CH F)) place))
  (define-values (a b) (values (state-named 'a) (state-named 'b)))
  (check-identity (omega (* DC a) (* DC b)) (omega a b)))

(test-case "Poisson brackets are kept"
  (define C (C-rotating 'n))
  (define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
  (define (angular s) (cross-product (coordinate s) (flip (momentum s))))
  (define-values (Lx Ly)
    (values (compose (component 0) angular) (compose (component 1) angular)))
  (check-identity ((compose (Poisson-bracket Lx Ly) C) space)
                  ((Poisson-bracket (compose Lx C) (compose Ly C)) space)))

;; Exercise 5.6: the composition of canonical transformations is one, and the inverse.
(test-case "canonical transformations form a group"
  (define C (compose (F->CH p->r) (polar-canonical 'alpha)))
  (check-pred proved? (verify-canonical C (up 't (up 'a 'b) (down 'I 'J))))
  (check-identity ((symplectic-transform? (polar-canonical-inverse 'alpha)) (up 't 'x 'p))
                  (* 0 (identity-matrix 2)))
  ;; the angle goes on in another branch where its formula jumps
  (check-equal? (map car (verdict-kinks (verify-canonical (polar-canonical-inverse 'alpha)
                                                          (up 't 'x 'p))))
                '(branch)))

(test-case "the symplectic form is scmutils' symplectic-two-form"
  (check-eq? omega symplectic-two-form))

(says
 [(omega (up 0 1 2) 3)
  "symplectic-two-form: expected a Hamiltonian state (up t q p)\n  given: the number 3"])
