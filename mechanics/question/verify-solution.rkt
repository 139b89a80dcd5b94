#lang racket/base
;; Does a proposed path solve Lagrange's equations, with constraints or without?

(require "kink-survey.rkt" "question-meaning.rkt" "question-remarks.rkt"
         "../calculus/verdict-with-decimals.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/on-demand.rkt"
         "../hamiltonian/as-Lagrangian.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/swapped-arguments.rkt"
         "../verdict/prove-zero.rkt" (only-in "../verdict/verdict.rkt" motion-claim))

(require-on-demand
 ["../constraint/eliminate.rkt" eliminate-multipliers]
 ["../constraint/equations.rkt" constrained-Lagrange-equations])

(provide verify-solution)

;; The verdict on the residual of the path q at a symbolic time t; where the path has kinks, or
;; no value, the residual does not tell.  With constraints but
;; no multipliers the question is whether there are any.
(define-plain (verify-solution given q [dissipation #f] #:force [Q #f] #:order [n 1]
                               #:constraints [constraints #f] #:multipliers [multipliers #f])
  (when (or constraints multipliers) (check-constrained n constraints))
  (define-values (L force) (as-Lagrangian-along given q Q))
  (with-handlers ([exn:fail:contract?
                   (lambda (e) (check-not-swapped 'verify-solution L q) (raise e))])
    (check-Lagrangian 'verify-solution L)
    (void (path 'verify-solution q))
    (define outside (external-force 'verify-solution force dissipation))
    (define residual
      (cond [multipliers
             ((constrained-Lagrange-equations L constraints #:force outside) q multipliers)]
            [constraints ((eliminate-multipliers L constraints #:force outside) q)]
            [else ((Lagrange-equations L #:force outside #:order n) q)]))
    (verdict-with-decimals
     (prove-zero
      residual
      #:motion-domain (domain-of-solution L q n outside)
      #:remarks (lambda () (remarks-on-solution L q n))
      #:surveys (lambda () (surveys-of-solution L q n outside constraints residual))
      #:meaning (lambda () (meaning-of-solution L q n outside))
      #:about (and (eqv? n 1) (motion-claim L q #f outside constraints multipliers))
      #:again (lambda (change)
                (define (if-any x) (and x (change x)))
                (verify-solution (change L) (change q) (if-any dissipation)
                                 #:force (if-any force) #:order n
                                 #:constraints (if-any constraints)
                                 #:multipliers (if-any multipliers))))
     (lambda () (q 't)))))

(define (check-constrained n constraints)
  (unless constraints
    (complain-showing 'verify-solution
                      "multipliers belong to constraints, and there are none"))
  (unless (eqv? n 1)
    (complain-showing 'verify-solution "with constraints, the order of a Lagrangian is 1"
                      "order" n)))
