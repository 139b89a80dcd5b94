#lang racket/base
;; Moving polynomials between rings of the same variables.

(require "monomial.rkt" "ring.rkt")

(provide rering)

;; The polynomial p of the ring `from`, in the ring `to`.
(define (rering from to p)
  (define (times i e m) (monomial+ m (variable-power to i e)))
  (cond [(eq? from to) p]
        [else
         (unless (null? p) (check-degree to (monomial-degree from (caar p))))
         (for/list ([t (in-list p)])
           (cons (monomial-fold from (car t) times (ring-one to)) (cdr t)))]))
