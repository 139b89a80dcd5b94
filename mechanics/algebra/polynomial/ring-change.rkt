#lang racket/base
;; Moving polynomials between rings of the same variables.

(require "monomial.rkt" "ring.rkt" "term-list.rkt")

(provide rering)

;; The polynomial p of the ring `from`, in the ring `to`.
(define (rering from to p)
  (define (times i e m) (monomial+ m (variable-power to i e)))
  (cond [(eq? from to) p]
        [else
         (unless (null? p) (check-degree to (monomial-degree from (leading-monomial p))))
         (for/list ([t (in-list p)])
           (make-term (monomial-fold from (term-monomial t) times (ring-one to))
                      (term-coefficient t)))]))
