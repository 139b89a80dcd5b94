#lang racket/base
;; SICM 5.4, Generating Functions (pp. 364–394), in the reader's own language.

(require mechanics)

(provide F1-flip F2-identity F1-polar-canonical)

;; The coordinates and momenta change places: p = q', p' = −q.
(define (F1-flip t q q-prime) (* q q-prime))

;; Nothing changes.
(define (F2-identity t q p-prime) (* p-prime q))

;; (5.109), p. 366: the polar-canonical transformation.
(define ((F1-polar-canonical alpha) t x theta)
  (* 1/2 alpha (square x) (cot theta)))
