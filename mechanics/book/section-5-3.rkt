#lang racket/base
;; SICM 5.3, Invariants of Canonical Transformations (pp. 357–364), in the reader's own language.

(require mechanics)

(provide omega)

;; The area that two increments of a state span in phase space (p. 361).
(define omega symplectic-two-form)
