#lang racket/base
;; Lagrange's equations with multipliers (SICM 1.10).
;;
;;   d/dt ∂₂L − ∂₁L − Q − Σ λ ∂₁G = 0,    G = 0;        with ∂₂A for A(t, q, v) = 0
;;
;; so that λ ∂₁G is the force that keeps G at zero: ∂₁L − d/dt ∂₂L + λ ∂₁G = 0.
;; For holonomic constraints these are Lagrange's equations of the augmented Lagrangian
;; L + λ G, in which the multipliers are coordinates without velocities.

(require "constraint.rkt" "constraint-jacobian.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../lagrangian/external-force.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" ref s:length))

(provide constrained-Lagrange-equations augmented-Lagrangian)

;; (((constrained-Lagrange-equations L constraints) q lambda) t)
;; -> (up residual-of-Lagrange's-equations values-of-the-constraints)
(define-plain (constrained-Lagrange-equations L constraints #:force [Q #f])
  (define who 'constrained-Lagrange-equations)
  (define cs (gather-with who L constraints))
  (define free (Lagrange-equations L #:force Q))
  (define (residual given-q [given-multipliers #f])
    (unless given-multipliers (raise-no-multipliers who cs))
    (define q (path who given-q))
    (define multipliers (multiplier-path who given-multipliers))
    (define residual (free q))
    (define local (Gamma q))
    (unary-function (lambda () (cons (name) (value->datum (list q multipliers)))) (t)
      (define here (local t))
      (check-linear who cs (coordinate here))
      (define values-of-constraints (constraint-values who cs here))
      (define lambdas (multipliers t))
      (check-multipliers who values-of-constraints lambdas)
      (check-count who (shape-length values-of-constraints) (coordinate here))
      (up (g:- (residual t) (force-of-multipliers who cs here lambdas))
          values-of-constraints)))
  (define name (apply call-datum who L cs (force->datum Q)))
  (make-function residual 4 name))

(define (raise-no-multipliers who cs)
  (complain who
            (string-append "the multipliers are missing; they are an argument beside the path"
                           "\n  constraints: ~a"
                           "\n  (eliminate-multipliers L constraints) "
                           "makes equations without them")
            (value->text cs)))

(define (multiplier-path who given)
  (unless (procedure? given)
    (complain who "multipliers are functions of time, as paths are; given ~a~a"
              (describe-with-value given)
              (cond [(symbol? given)
                     (format "\n  (literal-function '~a) makes a function of that name" given)]
                    [(number? given)
                     (format "\n  a constant one is (lambda (t) ~a)" given)]
                    [else ""])))
  (path who given))

;; Multipliers are shaped as the constraints are.
(define (check-multipliers who expected given)
  (unless (same-shape? expected given)
    (complain who "the multipliers must be ~a, like the constraints~a~a"
              (if (tuple? expected) (describe expected) "a number")
              (format "\n  multipliers: ~a" (value->text given))
              (format "\n  constraints: ~a" (value->text expected)))))

;; (t, (q, λ), (v, λ̇)) ↦ L + λ G
(define (augmented-Lagrangian L constraints)
  (define who 'augmented-Lagrangian)
  (define cs (gather-with who L constraints))
  (unless (all-holonomic? cs) (raise-not-holonomic who cs))
  (unary-function (call-datum who L cs) (local)
    (define-values (q multipliers) (halves who (coordinate local) "coordinates" "(up q lambda)"))
    (define-values (v rates) (halves who (velocity local) "velocities" "(up v lambda-dot)"))
    (define state (up (time local) q v))
    (define values-of-constraints (constraint-values who cs state))
    (check-multipliers who values-of-constraints multipliers)
    (for/fold ([sum (L state)])
              ([x (in-list (scalars multipliers))] [g (in-list (scalars values-of-constraints))])
      (g:+ sum (g:* x g)))))

(define (halves who x what expected)
  (unless (and (up? x) (= 2 (s:length x)))
    (complain who "expected ~a with multipliers, ~a; given ~a"
              what expected (describe-with-value x)))
  (values (ref x 0) (ref x 1)))

(define (raise-not-holonomic who cs)
  (complain who
            (string-append "with a nonholonomic constraint in the Lagrangian, "
                           "its equations are not those of the motion"
                           "\n  use constrained-Lagrange-equations"
                           "\n  constraints: ~a")
            (value->text cs)))
