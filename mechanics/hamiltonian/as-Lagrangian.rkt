#lang racket/base
;; Questions about a Lagrangian, asked of a Hamiltonian.

(require "declared.rkt"
         "../generic/on-demand.rkt")

(require-on-demand ["Legendre-transform.rkt" Hamiltonian->Lagrangian])

(provide as-Lagrangian)

;; The Lagrangian of a function that is known to be a Hamiltonian; any other is taken for one.
(define (as-Lagrangian f)
  (if (declared-Hamiltonian? f)
      (or (Lagrangian-of-declared f) (Hamiltonian->Lagrangian f))
      f))
