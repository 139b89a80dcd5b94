#lang racket/base
;; Questions about a Hamiltonian: do paths of coordinates and momenta solve Hamilton's equations,
;; and is a quantity conserved?  Brackets decide: Q̇ = {Q, H} + ∂₀Q, and + ∂₂Q F with a force F
;; outside H.

(require "argument-order.rkt" "kink-survey.rkt" "question-meaning.rkt" "question-remarks.rkt"
         "../calculus/verdict-with-decimals.rkt"
         "../generic/define-plain.rkt" "../generic/function-check.rkt"
         "../hamiltonian/H-state.rkt"
         "../hamiltonian/Hamilton-equations.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../hamiltonian/Poisson-bracket.rkt"
         "../lagrangian/generic-state.rkt"
         "../value/shape.rkt"
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt"
         "../verdict/question-domain.rkt"
         "../verdict/surveyed-zero.rkt" "../verdict/verdict.rkt")

(provide verify-Hamiltonian-solution
         ;; for verify-conserved and rate-of-change
         conserved-by-Hamiltonian rate-by-Hamiltonian)

;; ---------------------------------------------------------------------------
;; Solutions

;; The verdict on the residual of paths q and p at a symbolic time.
(define-plain (verify-Hamiltonian-solution H q p #:force [F #f])
  (check-order-of-arguments 'verify-Hamiltonian-solution '(H q p) (list H q p))
  (check-Hamiltonian-first 'verify-Hamiltonian-solution H q p)
  (check-Hamiltonian 'verify-Hamiltonian-solution H)
  (define v (judged-along H q p F))
  (if (and (refuted? v) (solve-exchanged? H q p F))
      (with-remark v (string-append "with q and p exchanged it is proved; "
                                    "the coordinates come first, then the momenta"))
      v))

;; Paths of one coordinate may stand for momenta as well.
(define (solve-exchanged? H q p F)
  (and (plain-procedure? q) (plain-procedure? p)
       (proved? (prove-zero ((Hamilton-equations H #:force F) p q)))))

(define (judged-along H q p F)
  (define states (states-along 'verify-Hamiltonian-solution q p))
  (define residual ((Hamilton-equations H #:force F) q p))
  (define domain (domain-of-states H states F))
  (verdict-with-decimals
   (prove-zero residual
               #:motion-domain domain
               #:remarks (lambda () (remarks-on-states H states))
               #:surveys (lambda () (surveys-of-states (Hamiltonian->state-derivative H #:force F)
                                                       states residual domain))
               #:meaning (lambda () (meaning-of-states H states))
               #:about (motion-claim H q p F #f #f)
               #:again (lambda (change)
                         (verify-Hamiltonian-solution (change H) (change q) (change p)
                                                      #:force (and F (change F)))))
   (lambda () (states 't))))

;; ---------------------------------------------------------------------------
;; Conserved quantities

;; The verdict on the rate of Q at a state (up t q p) of symbols.
(define (conserved-by-Hamiltonian who H Q state F)
  (check-Hamiltonian who H)
  (check-quantity who Q)
  (check-H-state who state)
  (check-symbols who state "state")
  (for ([f (in-list (list H Q F))] #:when (procedure? f)) (check-parameters who f state "state"))
  (verdict-with-decimals
   (prove-residual-zero (lambda () ((rate-by-Hamiltonian who H Q F) state)) (scalars state)
                        #:beside (list (survey-of-values (Q state)))
                        #:domain (lambda () (values-at (list H Q F) state))
                        #:within (lambda () (values-at (list H F) state))
                        #:functions (lambda () (values-at (list H Q) state))
                        #:remarks (lambda () (remarks-on-quantity Q state))
                        #:meaning (lambda () (meaning-of-quantity-in-phase-space H Q state))
                        #:about (conserved-claim H Q state F #t)
                        #:again (lambda (change)
                                  (conserved-by-Hamiltonian who (change H) (change Q) state
                                                            (and F (change F)))))
   (lambda () (Q state))))

;; state ↦ Q̇
(define (rate-by-Hamiltonian who H Q F)
  (define flow (flow-direction who H F))
  (lambda (state)
    (check-H-state who state)
    (define-values (velocity force) (flow state))
    (rate-of-quantity Q state velocity force)))
