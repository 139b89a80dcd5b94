#lang racket/base
;; The Hamiltonian without the perturbation, a function of the momenta alone.

(require "../../algebra/expression/symbols.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt")

(provide check-unperturbed)

;; state : of symbols
(define (check-unperturbed who H0 state)
  (define e (simplify-strictly (H0 state)))
  (for ([angle (in-list (scalars (coordinate state)))]
        #:when (occurs? angle e))
    (complain who
              (string-append "the Hamiltonian without the perturbation is to depend on the momenta "
                             "alone, but ~a depends on the angle ~a\n  its value: ~a"
                             "\n  action and angle make it so: for an oscillator, polar-canonical")
              (value->text H0) angle (value->text e))))
