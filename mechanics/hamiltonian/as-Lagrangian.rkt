#lang racket/base
;; Questions about a Lagrangian, asked of a Hamiltonian: of its Lagrangian, with forces and states
;; in terms of velocities.

(require "H-state.rkt" "known-Hamiltonians.rkt" "classify-system.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/describe.rkt" "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/on-demand.rkt" "../generic/up-down.rkt"
         "../lagrangian/function-name-hints.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../value/structure.rkt" flip))

(require-on-demand ["Legendre-transform.rkt" Hamiltonian->Lagrangian Lstate->Hstate])

(provide as-Lagrangian as-Lagrangian-along as-Lagrangian-at as-local)

;; -> the Lagrangian, and the force outside as a function of local tuples, or #f
;; A function that is not known to be a Hamiltonian is taken for a Lagrangian; one that is called a
;; Hamiltonian is refused, since the answer would be that to another question.
;; q : coordinates; force : a function of the same states as f, or #f
(define (as-Lagrangian who f q [force #f])
  (define told? (Hamiltonian-told? f q))
  (unless told? (check-not-called-Hamiltonian who f))
  (checked who f force told?))

(define (check-not-called-Hamiltonian who f)
  (when (called-Hamiltonian? f)
    (complain who
              (string-append
               "this is called a Hamiltonian, and nothing else tells it from a Lagrangian: ~a"
               "\n  a Hamiltonian is made known by (make-Hamiltonian ~a)"
               "\n  of a Lagrangian, take another name")
              (value->text f) (value->text f))))

;; The same where there is a path q.  Neither q nor f is checked: whoever solves the equations
;; checks them.
(define (as-Lagrangian-along f q [force #f])
  (define (position) (q (string->uninterned-symbol "t")))
  (converted f force
             (Hamiltonian-told? f (if-raised raised? 0 (position)))))

;; The same where there is a state, of velocities or of momenta.
(define (as-Lagrangian-at who f state [force #f])
  (checked who f force (told-by-state? who f state)))

;; The state with velocities of the same names in place of momenta.
(define (as-local state)
  (if (state-of-momenta? state)
      (up (time state) (coordinate state) (flip (adopt (momentum state))))
      state))

(define (checked who f force Hamiltonian?)
  (unless Hamiltonian? (check-Lagrangian who f))
  (converted f force Hamiltonian?))

(define (converted f force Hamiltonian?)
  (cond [Hamiltonian?
         (define L (Lagrangian-of f))
         (values L (and force (force-of-velocities L force)))]
        [else (values f force)]))

(define (Lagrangian-of H)
  (or (and (declared-Hamiltonian? H) (Lagrangian-of-declared H))
      (Hamiltonian->Lagrangian H)))

;; (t, q, v) ↦ F(t, q, ∂₂L); a value that is no function is returned, for the check of forces.
(define (force-of-velocities L force)
  (if (takes-arguments? force 1)
      (unary-function (lambda () (value->datum force)) (local)
        (force ((Lstate->Hstate L) local)))
      force))
