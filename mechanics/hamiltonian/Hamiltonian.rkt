#lang racket/base
;; Hamiltonians, and the errors of functions that are none.

(require "H-state.rkt" "known-Hamiltonians.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/function-name-hints.rkt")

(provide make-Hamiltonian check-Hamiltonian check-Hamiltonian-and-state
         called-Lagrangian-only? raise-called-Lagrangian
         number-valued check-quantity)

;; (make-Hamiltonian T V) : T + V, of functions of the state, or of parameters that give such
;; functions; (make-Hamiltonian H) : H, known from now on to be a Hamiltonian
(define make-Hamiltonian
  (case-lambda
    [(H)
     (check-Hamiltonian 'make-Hamiltonian H)
     (if (declared-Hamiltonian? H)
         H
         (declared-Hamiltonian (unary-function (lambda () (value->datum H)) (state) (H state))))]
    [(kinetic-energy potential-energy)
     (for ([f (in-list (list kinetic-energy potential-energy))])
       (check-argument 'make-Hamiltonian procedure? f "an energy: a function of the state"))
     (define sum (g:+ kinetic-energy potential-energy))
     (if (accepts? sum 1) (make-Hamiltonian sum) sum)]))

;; H is asked about at a state, where a Lagrangian would have a value, too, which is no energy.
(define (check-Hamiltonian-and-state who H state)
  (check-comes-first who (and (tuple? H) (pointwise? state)) "Hamiltonian" "state")
  (check-Hamiltonian who H)
  (check-H-state who state)
  (when (called-Lagrangian-only? H) (raise-called-Lagrangian who H)))

;; Is H called a Lagrangian, and not known to be a Hamiltonian?
(define (called-Lagrangian-only? H)
  (and (not (declared-Hamiltonian? H)) (called-Lagrangian? H)))

(define (raise-called-Lagrangian who H)
  (complain who (string-append "expected a Hamiltonian; this is called a Lagrangian: ~a"
                               "\n  (Lagrangian->Hamiltonian L) makes a Hamiltonian of it"
                               "\n  if it is one whatever its name: (make-Hamiltonian ~a)")
            (value->text H) (value->text H)))

(define (check-Hamiltonian who H)
  (unless (and (procedure? H) (not (tuple? H)))
    (complain who "a Hamiltonian is a function of the state (up t q p); given ~a~a"
              (describe-with-value H) (quoted-name-hint H)))
  (unless (accepts? H 1)
    (complain who
              (string-append "a Hamiltonian takes one argument, the state, but ~a does not."
                             "\n  If it takes parameters first, supply them: (~a (~a ...))~a")
              (value->text H) who (value->text H)
              (if (accepts? H 3)
                  (string-append "\n  If it takes the time, coordinates and momenta, "
                                 "write them as one argument: (up t q p)")
                  ""))))

(define (check-quantity who Q)
  (check-takes who Q 1 "a quantity is a function of the state (up t q p)"))

;; H, whose value is checked to be a number.
(define ((number-valued who H) state)
  (define (hint value) (if (pointwise? value) "\n  was a parameter left out, as a mass?" ""))
  (check-scalar-value who "a Hamiltonian" H (H state) hint))
