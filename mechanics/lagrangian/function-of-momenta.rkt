#lang racket/base
;; Functions of momenta, which are no Lagrangians.  A Hamiltonian that is known to be one carries
;; this mark (hamiltonian/known-Hamiltonians.rkt); a procedure that takes only Lagrangians refuses
;; it, and names the procedure for Hamiltonians.

(require "../error/complain.rkt" "../generic/describe.rkt")

(provide prop:of-momenta of-momenta? raise-of-momenta)

(define-values (prop:of-momenta of-momenta? _value) (make-struct-type-property 'of-momenta))

(define (raise-of-momenta who H)
  (complain who "expected a Lagrangian; this is known to be a Hamiltonian: ~a\n  ~a"
            (value->text H)
            (case who
              [(Lagrange-equations generalized-LE)
               "its equations of motion are (Hamilton-equations H)"]
              [(Lagrangian->state-derivative)
               "the rates of its states are (Hamiltonian->state-derivative H)"]
              [(Lagrangian-action)
               "its action is (Hamiltonian-action H q p t1 t2)"]
              [(Lagrangian->energy) "it is the energy itself, as a function of the momenta"]
              [(verify-total-time-derivative gauge-function)
               (string-append
                "total time derivatives are functions of the local tuple (up t q v); whether two "
                "Hamiltonians\n  differ by one, (compare-Lagrangians H1 H2 state) tells")]
              [else "its Lagrangian is (Hamiltonian->Lagrangian H)"])))
