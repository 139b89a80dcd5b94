#lang racket/base
;; What can be asked to separate: a Hamiltonian without explicit time, in which all momenta are, and
;; an energy that is constant; and names for the other constants.

(require "separated-equation.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/scalar.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" "../value/simplify.rkt")

(provide checked-value constant-name)

;; -> H at the state of symbols, an expression
(define (checked-value who H state energy)
  (check-Hamiltonian-and-state who H state)
  (check-symbols who state "state")
  (define e (simplify-strictly ((number-valued who H) state)))
  (check-parameters who H state "state")
  (check-motion who H state e)
  (check-energy who H state e energy)
  e)

(define (check-motion who H state e)
  (when (holds? e (time state))
    (complain who
              (string-append "~a depends on the time ~a; extended-Hamiltonian makes the time a "
                             "coordinate\n  its value: ~a")
              (value->text H) (time state) (value->text e)))
  (for ([p (in-list (scalars (momentum state)))] #:unless (holds? e p))
    (complain who
              "~a does not depend on the momentum ~a: its coordinate rests, and separates nothing"
              (value->text H) p)))

(define (check-energy who H state e energy)
  (unless (scalar? energy)
    (complain who "the energy is a symbol or a number; given ~a" (describe-with-value energy)))
  (when (or (holds? e energy) (memq energy (scalars state)))
    (complain who
              (string-append "the symbol ~a, for the energy, stands in ~a or in the state, too; "
                             "#:energy names another")
              energy (value->text H)))
  (for ([x (in-list (scalars state))] #:when (holds? energy x))
    (complain who "the energy is constant, and does not depend on the state; given ~a"
              (value->text energy))))

;; q -> alpha_q, primed where that is taken
(define ((constant-name e energy) q)
  (let retry ([name (format "alpha_~a" q)])
    (define symbol (string->symbol name))
    (if (or (holds? e symbol) (eq? symbol energy)) (retry (string-append name "prime")) symbol)))
