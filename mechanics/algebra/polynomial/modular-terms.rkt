#lang racket/base
;; Sparse polynomials over a prime field: lists of terms (term-list.rkt) with
;; residues for coefficients.

(require racket/fixnum
         "arithmetic.rkt" "modular.rkt" "monomial.rkt" "ring.rkt" "term-list.rkt")

(provide terms-mod put-mod monomial-value)

;; The residues of a polynomial with integer coefficients.
(define (terms-mod p P)
  (for*/list ([t (in-list p)]
              [c (in-value (modulo (term-coefficient t) P))]
              #:unless (eq? c 0))
    (make-term (term-monomial t) c)))

;; p with the residue a for variable i.
(define (put-mod R p i a P)
  (define by-degree (make-hasheqv))
  (for ([t (in-list p)])
    (define e (monomial-exponent R (term-monomial t) i))
    (hash-set! by-degree e (cons t (hash-ref by-degree e '()))))
  (for/fold ([sum '()]) ([(e terms) (in-hash by-degree)])
    (define power (mod-expt a e P))
    (add-mod sum (strip terms (variable-power R i e) power P) P)))

;; Terms in increasing order, divided by m and scaled, in decreasing order.
(define (strip terms m scale P)
  (for/fold ([result '()]) ([t (in-list terms)])
    (cons (make-term (monomial- (term-monomial t) m) (mod* scale (term-coefficient t) P))
          result)))

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
