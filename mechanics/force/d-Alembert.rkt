#lang racket/base
;; d'Alembert's principle: Newton's equations for particles at r(t, q), as far as the
;; coordinates see them.
;;
;; Newton's law says m_k r̈_k = F_k + C_k, with C_k the unknown force of the constraint.
;; If constraints do no work in virtual displacements then, for each coordinate,
;;
;;   Σ (m_k r̈_k − F_k)·∂r_k/∂q_j = 0.
;;
;; This is d/dt ∂T/∂q̇_j − ∂T/∂q_j − Q_j with T the kinetic energy, which Lagrange found;
;; but here it is computed from accelerations, so that the one can be checked by the other.

(require "force.rkt" "generalized-force.rkt" "masses.rkt" "particles.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../calculus/derivative.rkt"
         "../lagrangian/local-tuple.rkt")

(provide d-Alembert-equations)

;; (((d-Alembert-equations masses r F) q) t)
(define (d-Alembert-equations masses r F)
  (define who 'd-Alembert-equations)
  (check-masses who masses)
  (check-positions who r)
  (check-force who F)
  (define (name) (list who (masses->datum masses) (value->datum r) (value->datum F)))
  (unary-function name (given-q)
    (define q (path who given-q))
    (unary-function (lambda () (list (name) (value->datum q))) (t)
      (residual-at who masses r F q t))))

(define (residual-at who masses r F q t)
  (define (positions t) (positions-at who r t (q t)))
  (define-values (x v a) (apply values (derivatives-at positions t 2)))
  (check-masses-fit who masses x)
  (define forces (forces-at who F t x v))
  (g:- (along-coordinates (times-masses masses a) r t (q t))
       (along-coordinates forces r t (q t))))
