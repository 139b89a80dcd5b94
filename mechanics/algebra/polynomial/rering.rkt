#lang racket/base
;; Moving polynomials between rings of the same variables.

(require "ring.rkt" "arithmetic.rkt")

(provide rering)

;; The polynomial p of the ring `from`, in the ring `to`.
(define (rering from to p)
  (for/list ([t (in-list p)])
    (cons (exponents->monomial to (monomial-exponents from (car t))) (cdr t))))
