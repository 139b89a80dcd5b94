#lang racket/base
;; Equations of motion without multipliers.
;;
;; The force of a constraint does no work in a motion δq that the constraints allow, J δq = 0:
;; the residual of Lagrange's equations in such directions is free of
;; multipliers.  A basis of these directions is the null space of the Jacobian J; or, where
;; coordinates s are known by which the constraints are kept, q = F(t, s), it is ∂F/∂s, and
;; the residual that is left is that of the Lagrangian in these coordinates.

(require (only-in racket/list list-set)
         "constraint.rkt" "constraint-jacobian.rkt"
         "../generic/define-plain.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/compose.rkt" "../value/shape.rkt"
         (only-in "../value/structure.rkt" list->down list->up structure->list)
         "../value/matrix/row-products.rkt" "../value/matrix/row-systems.rkt")

(provide eliminate-multipliers)

;; (((eliminate-multipliers L constraints) q) t) -> (up residuals values-of-the-constraints)
;; F : as for F->C; with it, q is the path of its coordinates.
(define-plain (eliminate-multipliers L constraints [F #f] #:force [Q #f])
  (define who 'eliminate-multipliers)
  (define cs (gather-with who L constraints))
  (define free (Lagrange-equations L #:force Q))
  (unless (or (not F) (takes-arguments? F 1))
    (complain-of-argument who "a coordinate transformation: a function of the local tuple" F))
  (define name
    (apply call-datum who L cs (append (if F (list F) '()) (force->datum Q))))
  (unary-function name (given-path)
    (define s (path who given-path))
    (define q (if F (compose F (Gamma s)) s))
    (define-values (residual local) (values (free q) (Gamma q)))
    (define (directions t)
      (if F (slopes F ((Gamma s) t)) (allowed who cs (local t))))
    (unary-function (lambda () (list (name) (value->datum s))) (t)
      (check-linear who cs (coordinate (local t)))
      (define left
        (let ([all (list->vector (scalars (residual t)))])
          (for/list ([d (in-list (directions t))]) (sum-of-products d all))))
      (up (shape-like (and F (s t)) left) (constraint-values who cs (local t))))))

;; The columns of ∂F/∂s.
(define (slopes F local)
  (define (at s) (F (list->up (list-set (structure->list local) 1 s))))
  (vector->list (rows-transpose (rows-of-function at (coordinate local)))))

;; A basis of the directions that the constraints allow.
(define (allowed who cs local)
  (define J (jacobian-rows who cs local))
  (check-count who (length J) (coordinate local))
  (rows-null-space who J (list->vector J)))

;; One residual is a number, several are a down tuple.
(define (shape-like s xs)
  (if (tuple? s) (list->down xs) (single-or list->down xs)))
