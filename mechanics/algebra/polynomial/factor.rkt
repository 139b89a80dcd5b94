#lang racket/base
;; Factors of polynomials over the rationals.
;;
;; Multiplicities, and factors with different variables, are told apart by gcds
;; (parts.rkt).  Of what is left, no factor is free of a variable that occurs: so
;; it is irreducible if it is linear in one.  A homogeneous polynomial is factored
;; with one variable set to 1, which takes nothing away.

(require "arithmetic.rkt" "content.rkt" "coprime-basis.rkt" "inspect.rkt" "integer-factor.rkt"
         "lifted-factor.rkt" "monomial.rkt" "parts.rkt" "ring.rkt")

(provide poly-factor)

;; ((factor . multiplicity) ...): primitive, with positive leading coefficients;
;; their product is p up to a rational factor.  Factors are irreducible, but for
;; those that were too much work.  Those of low degree come first, and among them
;; those with the first variables.
(define (poly-factor R p)
  (define factors
    (for*/list ([part (in-list (poly-parts R p))]
                [f (in-list (part-factors R (car part)))])
      (cons f (cdr part))))
  (sort (basis-sort factors) (lambda (f g) (before? R (car f) (car g)))))

(define (before? R p q)
  (define m (poly-total-degree R p))
  (define n (poly-total-degree R q))
  (or (< m n)
      (and (eqv? m n) (monomial>? (caar p) (caar q)))))

(define (part-factors R p)
  (define variables (poly-variables R p))
  (cond [(null? (cdr p)) (list p)]
        [(for/or ([i (in-list variables)]) (eqv? 1 (poly-degree R p i))) (list p)]
        [(null? (cdr variables)) (univariate-factors R p (car variables))]
        [(homogeneous? R p) (homogeneous-factors R p (car variables))]
        [else (lifted-factors R p)]))

;; ---------------------------------------------------------------------------
;; One variable

(define (univariate-factors R p x)
  (define v (make-vector (+ 1 (poly-degree R p x)) 0))
  (for ([t (in-list p)]) (vector-set! v (monomial-exponent R (car t) x) (cdr t)))
  (for/list ([f (in-list (integer-factors v))])
    (poly-sum R
      (for/list ([c (in-vector f)] [e (in-naturals)] #:unless (eqv? c 0))
        (poly-scale R c (poly-variable R x e))))))

;; ---------------------------------------------------------------------------
;; Homogeneous polynomials

(define (homogeneous? R p)
  (define degree (poly-total-degree R p))
  (for/and ([t (in-list p)]) (eqv? degree (monomial-degree R (car t)))))

;; With x set to 1, factored, and each term brought to the degree of its factor.
(define (homogeneous-factors R p x)
  (for*/list ([f (in-list (poly-factor R (poly-substitute R p x (poly-constant R 1))))]
              [_ (in-range (cdr f))])
    (define degree (poly-total-degree R (car f)))
    (define-values (content primitive)
      (poly-primitive R
        (poly-sum R
          (for/list ([t (in-list (car f))])
            (define room (- degree (monomial-degree R (car t))))
            (list (cons (monomial+ (car t) (variable-power R x room)) (cdr t)))))))
    primitive))
