#lang racket/base
;; Equations of motion without multipliers.
;;
;; The force of a constraint does no work in a motion δq that the constraints allow, J δq = 0:
;; what is left of the residual of Lagrange's equations in such directions is free of
;; multipliers.  A basis of these directions is the null space of the Jacobian J; or, where
;; coordinates s are known by which the constraints are kept, q = F(t, s), it is ∂F/∂s, and
;; the residual that is left is that of the Lagrangian in these coordinates.

(require "constraint.rkt" "linearized.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/compose.rkt" "../value/shape.rkt"
         "../value/matrix/row-products.rkt" "../value/matrix/row-systems.rkt")

(provide eliminate-multipliers)

;; (((eliminate-multipliers L constraints) q) t) -> (up residuals values-of-the-constraints)
;; F : as for F->C; with it, q is the path of its coordinates.
(define-plain (eliminate-multipliers L constraints [F #f] #:force [Q #f])
  (define who 'eliminate-multipliers)
  (define cs (gather-with who L constraints))
  (define free (Lagrange-equations L #:force Q))
  (unless (or (not F) (and (procedure? F) (accepts? F 1)))
    (complain-of-argument who "a coordinate transformation: a function of the local tuple" F))
  (define (name)
    `(,who ,(value->datum L) ,(constraints->datum cs) ,@(if F (list (value->datum F)) '())
           ,@(force->datum Q)))
  (unary-function name (given-path)
    (define s (path who given-path))
    (define q (if F (compose F (Gamma s)) s))
    (define-values (residual local) (values (free q) (Gamma q)))
    (define (directions t)
      (if F (slopes F ((Gamma s) t)) (allowed who cs (local t))))
    (unary-function (lambda () (list (name) (value->datum s))) (t)
      (define-values (q v) (values (coordinate (local t)) (velocity (local t))))
      (check-linear who cs q)
      (define left (in-directions (directions t) (list->vector (scalars (residual t)))))
      (up (shape-like (and F (s t)) left) (constraint-values who cs t q v)))))

;; The columns of ∂F/∂s.
(define (slopes F local)
  (define rest (cdr (structure->elements local)))
  (define (at s) (F (structure 'up (list->vector (list* (time local) s (cdr rest))))))
  (vector->list (rows-transpose (rows-of-function at (car rest)))))

(define (structure->elements s) (vector->list (structure-elements s)))

;; A basis of what the constraints allow.
(define (allowed who cs local)
  (define-values (t q v) (values (time local) (coordinate local) (velocity local)))
  (define J (jacobian-rows who cs t q v))
  (check-count who (length J) q)
  (rows-null-space who J (list->vector J)))

(define (in-directions directions residual)
  (for/list ([d (in-list directions)]) (sum-of-products d residual)))

;; One residual is a number, several are a down tuple.
(define (shape-like s xs)
  (define only (and (pair? xs) (null? (cdr xs)) (not (tuple? s))))
  (if only (car xs) (structure 'down (list->vector xs))))
