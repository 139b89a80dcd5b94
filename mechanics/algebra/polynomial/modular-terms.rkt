#lang racket/base
;; Sparse polynomials over a prime field: the terms of polynomial.rkt with
;; residues for coefficients.

(require racket/fixnum "monomial.rkt" "ring.rkt" "modular.rkt")

(provide terms-mod put-mod monomial-value)

;; The residues of a polynomial with integer coefficients.
(define (terms-mod p P)
  (for*/list ([t (in-list p)]
              [c (in-value (modulo (cdr t) P))]
              #:unless (eq? c 0))
    (cons (car t) c)))

;; p with the residue a for variable i.
(define (put-mod R p i a P)
  (define by-degree (make-hasheqv))
  (for ([t (in-list p)])
    (define e (monomial-exponent R (car t) i))
    (hash-set! by-degree e (cons t (hash-ref by-degree e '()))))
  (for/fold ([sum '()]) ([(e terms) (in-hash by-degree)])
    (define power (mod-expt a e P))
    (add-mod sum (strip terms (variable-power R i e) power P) P)))

;; Terms in increasing order, divided by m and scaled, in decreasing order.
(define (strip terms m scale P)
  (for/fold ([result '()]) ([t (in-list terms)])
    (cons (cons (monomial- (car t) m) (mod* scale (cdr t) P)) result)))

(define (add-mod p q P)
  (cond [(null? p) q]
        [(null? q) p]
        [else
         (define order (monomial-compare (caar p) (caar q)))
         (cond [(fx> order 0) (cons (car p) (add-mod (cdr p) q P))]
               [(fx< order 0) (cons (car q) (add-mod p (cdr q) P))]
               [else
                (define c (mod+ (cdar p) (cdar q) P))
                (define rest (add-mod (cdr p) (cdr q) P))
                (if (eq? c 0) rest (cons (cons (caar p) c) rest))])]))

;; The value of a monomial, leaving out the variable `skip`.
;; point : fxvector of residues by variable
(define (monomial-value R m skip point P)
  (monomial-fold R m
                 (lambda (i e value)
                   (if (eq? i skip)
                       value
                       (mod* value (mod-expt (fxvector-ref point i) e P) P)))
                 1))
