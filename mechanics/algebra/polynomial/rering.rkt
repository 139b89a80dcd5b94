#lang racket/base
;; Moving polynomials between rings of the same variables.

(require "ring.rkt" "arithmetic.rkt")

(provide rering)

;; The polynomial p of the ring `from`, in the ring `to`.
(define (rering from to p)
  (if (eq? from to)
      p
      (for/list ([t (in-list p)])
        (cons (factors->monomial to (monomial-factors from (car t))) (cdr t)))))
