#lang racket/base
;; Constraints substituted in the Lagrangian: the cases where one may, and the result otherwise.
;;
;; Coordinates that keep a holonomic constraint may be substituted in L; velocities that keep
;; a nonholonomic one may not, for variations do not keep it.  The result of the wrong
;; way may still be right for one system.  So the true motion, found with multipliers, is put
;; into the equations of the substituted Lagrangian.

(require "accelerations.rkt" "constraint.rkt" "constraint-jacobian.rkt" "integrability.rkt"
         "../error/complain.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/generic-state.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" list->up ref)
         "../value/matrix/row-products.rkt" "../value/matrix/row-systems.rkt"
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide reduce-by-substitution reduction?)

;; A Lagrangian, and two verdicts: are the constraints integrable, and is the true motion one
;; of this Lagrangian?
(value-struct reduction (Lagrangian integrability agreement)
  #:text report
  #:property prop:procedure 0)

(provide-parts reduction? "what reduce-by-substitution gives"
  reduction-integrability reduction-agreement)

(define (report r)
  (define agreement (reduction-agreement r))
  (string-append
   "a Lagrangian with velocities substituted"
   "\n  the constraints: "
   (by-status (reduction-integrability r)
              "integrable, holonomic in disguise"
              "nonholonomic; to substitute them is no valid step"
              "not known to be integrable")
   "\n  its equations: "
   (by-status agreement
              "the motion satisfies them, as it happens for this system"
              (format "wrong; the motion leaves ~a" (value->text (verdict-residual agreement)))
              "not decided")))

(define (by-status v proved refuted undecided)
  (cond [(proved? v) proved] [(refuted? v) refuted] [else undecided]))

;; substitute : (t, q, v) -> velocities that keep the constraints
;; state : of symbols; kept : constraints that stay, with multipliers
(define-plain (reduce-by-substitution L constraints substitute state #:keep [kept #f])
  (define who 'reduce-by-substitution)
  (define cs (gather-with who L constraints))
  (unless (takes-arguments? substitute 3)
    (complain-of-argument who "a function (t q v) of velocities that keep the constraints"
                          substitute))
  (check-generic who cs state)
  (check-parameters who L state)
  (define (substituted local)
    (define-values (t q v) (state-parts local))
    (up t q (substitute t q v)))
  (define true-state (substituted state))
  (define-values (t q v) (state-parts true-state))
  (check-substitution who cs true-state)
  (define (reduced local) (L (substituted local)))
  (define a (ref ((constrained-accelerations L cs) true-state) 0))
  (define-values (residual survey)
    (survey-derivatives (lambda () ((Euler-Lagrange-operator reduced) (up t q v a)))
                        (scalars state)))
  (reduction (printed-function (reduce-by-substitution L) (local) (reduced local))
             (Frobenius-test cs q)
             (prove-zero (if kept
                             (in-allowed who (gather who kept) true-state residual)
                             residual)
                         #:surveys (list survey))))

(define (check-substitution who cs state)
  (define-values (positions rates) (positions-and-velocities who cs state))
  (define verdict (prove-zero (list->up rates)))
  (when (refuted? verdict)
    (complain who "the velocities do not keep the constraints\n  velocities: ~a\n  constraints: ~a"
              (value->text (velocity state)) (value->text (verdict-residual verdict)))))

;; The components of the residual in the directions that the kept constraints allow.
(define (in-allowed who kept state residual)
  (define J (jacobian-rows who kept state))
  (define left (list->vector (scalars residual)))
  (down-of
   (for/vector ([d (in-list (rows-null-space who J (list->vector J)))]) (sum-of-products d left))))
