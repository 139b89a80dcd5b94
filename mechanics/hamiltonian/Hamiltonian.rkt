#lang racket/base
;; Hamiltonians, and what is wrong with those that are none.

(require "H-state.rkt" "known-Hamiltonians.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/name-hints.rkt")

(provide make-Hamiltonian check-Hamiltonian check-Hamiltonian-and-state
         called-Lagrangian-only? raise-called-Lagrangian
         number-valued check-quantity)

;; (make-Hamiltonian T V) : T + V, of functions of the state, or of parameters with such as
;; values; (make-Hamiltonian H) : H, known from now on to be a Hamiltonian
(define make-Hamiltonian
  (case-lambda
    [(H)
     (check-Hamiltonian 'make-Hamiltonian H)
     (if (declared-Hamiltonian? H) H (declared-Hamiltonian (one-argument H)))]
    [(kinetic-energy potential-energy)
     (for ([f (in-list (list kinetic-energy potential-energy))])
       (unless (procedure? f)
         (complain-of-argument 'make-Hamiltonian "an energy: a function of the state" f)))
     (define sum (g:+ kinetic-energy potential-energy))
     (if (accepts? sum 1) (make-Hamiltonian sum) sum)]))

(define (one-argument H) (unary-function (lambda () (value->datum H)) (state) (H state)))

;; Of one that is asked about at a state: a Lagrangian has a value there, too, which is no energy.
(define (check-Hamiltonian-and-state who H state)
  (when (and (tuple? H) (pointwise? state))
    (complain who "the Hamiltonian comes first, then the state; these look swapped"))
  (check-Hamiltonian who H)
  (check-H-state who state)
  (when (called-Lagrangian-only? H) (raise-called-Lagrangian who H)))

;; Is there nothing else that tells?  One that was said to be a Hamiltonian may have any name.
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
  (unless (and (procedure? Q) (accepts? Q 1))
    (complain who "a quantity is a function of the state (up t q p); given ~a"
              (describe-function Q))))

;; H, refusing to go on when its value is no number.
(define (number-valued who H)
  (lambda (state)
    (define value (H state))
    (unless (scalar? value)
      (complain who "the value of a Hamiltonian is a number, but that of ~a is ~a~a"
                (value->text H) (describe-with-value value)
                (if (pointwise? value) "\n  was a parameter left out, as a mass?" "")))
    value))
