#lang racket/base
;; Sparse polynomials over a prime field: lists of terms (term-list.rkt) with
;; residues for coefficients.

(require racket/fixnum
         "arithmetic.rkt" "modular.rkt" "polynomial-parts.rkt" "ring.rkt" "term-list.rkt")

(provide terms-mod put-mod monomial-value)

;; The residues of a polynomial with integer coefficients.
(define (terms-mod p P)
  (for*/list ([t (in-list p)]
              [c (in-value (modulo (term-coefficient t) P))]
              #:unless (eq? c 0))
    (make-term (term-monomial t) c)))

;; p with the residue a for variable i.
(define (put-mod R p i a P)
  (for/fold ([sum '()]) ([s (in-list (poly-coefficients R p i))])
    (add-mod sum (scale-mod (mod-expt a (slice-degree s) P) (slice-coefficient s) P) P)))

(define (scale-mod c p P)
  (for/list ([t (in-list p)]) (make-term (term-monomial t) (mod* c (term-coefficient t) P))))

(define-sum (add-mod p q P) mod+)

;; The value of a monomial, leaving out the variable `skip`.
;; point : fxvector of residues by variable
(define (monomial-value R m skip point P)
  (monomial-fold R m
                 (lambda (i e value)
                   (if (eq? i skip)
                       value
                       (mod* value (mod-expt (fxvector-ref point i) e P) P)))
                 1))
