#lang racket/base
;; The total time derivative and the Euler–Lagrange operator: functions of local
;; tuples into functions of longer ones (SICM 1.9, pp. 97–98).
;;
;; Along a path the local tuple moves in the direction (1, v, a, ...), so that
;;
;;   D_t F (t, q, v, a, ...) = ∂₀F + ∂₁F v + ∂₂F a + ...
;;
;; is the derivative of F in that direction.  It wants one component more than F.

(require "local-tuple.rkt" "Lagrange-equations.rkt"
         "../generic/structure.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/arithmetic.rkt"
         "../calculus/derivative.rkt"
         "../value/structure.rkt" "../value/operator.rkt" "../value/function.rkt")

(provide Dt Euler-Lagrange-operator LE Lagrange-equations-operator
         clip-state trim-last-argument)

;; ((Dt F) local)
(define Dt
  (make-primitive-operator
   (lambda (F)
     (unless (procedure? F)
       (raise-argument-error 'Dt "a function of the local tuple" F))
     (unary-function (lambda () (list 'Dt (value->datum F))) (local)
       (total-derivative F local)))
   (lambda () 'Dt)))

(define (total-derivative F local)
  (check-local-tuple 'Dt local)
  (define-values (value slope)
    (value-and-derivative-along F (trim-last-argument local) (drift local)))
  slope)

;; (1, v, a, ...)
(define (drift local)
  (list->up (cons 1 (cddr (structure->list local)))))

(define (check-local-tuple who local)
  (unless (and (local-tuple? local) (>= (s:length local) 3))
    (raise
     (exn:fail:contract
      (format "~a: expected a local tuple (up t q v ...); given ~a"
              who (describe-with-value local))
      (current-continuation-marks))))
  (for ([part (in-list (cddr (structure->list local)))])
    (unless (same-shape? part (coordinate local))
      (raise
       (exn:fail:contract
        (format "~a: the parts of the local tuple differ in shape\n  coordinates: ~a\n  another: ~a"
                who (value->text (coordinate local)) (value->text part))
        (current-continuation-marks))))))

;; The residual of Lagrange's equations as a function of (t, q, v, a).
(define (Euler-Lagrange-operator L)
  (check-Lagrangian 'Euler-Lagrange-operator L)
  (define L-scalar (scalar-valued 'Euler-Lagrange-operator L))
  (define residual
    (g:- (Dt ((partial 2) L-scalar)) (compose ((partial 1) L-scalar) trim-last-argument)))
  (unary-function (lambda () (list 'Euler-Lagrange-operator (value->datum L))) (local)
    (residual local)))

(define LE Euler-Lagrange-operator)
(define Lagrange-equations-operator Euler-Lagrange-operator)

;; ((clip-state n) local): the first n components.
(define (clip-state n)
  (unless (and (exact-integer? n) (>= n 2))
    (raise-argument-error 'clip-state "a length of local tuples, an integer of at least 2" n))
  (lambda (local)
    (unless (and (up? local) (<= n (s:length local)))
      (raise
       (exn:fail:contract
        (format "clip-state: expected a local tuple of at least ~a components; given ~a"
                n (describe-with-value local))
        (current-continuation-marks))))
    (for/fold ([parts '()] #:result (list->up (reverse parts)))
              ([part (in-vector (structure-elements (adopt local)))] [_ (in-range n)])
      (cons part parts))))

;; All components but the last.
(define (trim-last-argument local)
  (unless (up? local)
    (raise
     (exn:fail:contract
      (format "trim-last-argument: expected a local tuple; given ~a" (describe-with-value local))
      (current-continuation-marks))))
  ((clip-state (sub1 (s:length local))) local))
