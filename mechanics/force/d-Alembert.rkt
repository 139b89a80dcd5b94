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
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/kind.rkt" "../generic/value-struct.rkt"
         "../lagrangian/local-tuple.rkt")

(provide d-Alembert-equations
         newtonian? newtonian-masses newtonian-positions newtonian-force)

;; A function of paths that keeps its masses, positions and force, for derivations.
(define kind:newtonian
  (make-kind #:rank rank:function
             #:describe (lambda (e) "a function of paths")
             #:datum newtonian->datum
             #:arity (lambda (e) 2)))

(value-struct newtonian (masses positions force)
  #:kind kind:newtonian
  #:property prop:procedure
  (case-lambda [(e q) (residual-along e q)]
               [(e . arguments) (raise-one-path e arguments)]))

(define (newtonian->datum e)
  (list 'd-Alembert-equations (masses->datum (newtonian-masses e))
        (value->datum (newtonian-positions e)) (value->datum (newtonian-force e))))

(define (raise-one-path e arguments)
  (complain-of-arity 'd-Alembert-equations
                     "the equations take one argument, a path; they were given ~a~a"
                     (if (null? arguments) "none" (length arguments))
                     (if (= (length arguments) 2)
                         "\n  the time comes next: ((equations path) time)"
                         "")))

;; (((d-Alembert-equations masses r F) q) t)
(define (d-Alembert-equations masses r F)
  (define who 'd-Alembert-equations)
  (check-masses who masses)
  (check-positions who r)
  (check-force who F)
  (newtonian masses r F))

(define (residual-along e given-q)
  (define who 'd-Alembert-equations)
  (define q (path who given-q))
  (unary-function (lambda () (value->datum (list e q))) (t)
    (residual-at who (newtonian-masses e) (newtonian-positions e) (newtonian-force e) q t)))

(define (residual-at who masses r F q t)
  (define (positions t) (positions-at who r t (q t)))
  (define-values (x v a) (apply values (derivatives-at positions t 2)))
  (check-masses-fit who masses x)
  (define forces (forces-at who F t x v))
  (g:- (along-coordinates (times-masses masses a) r t (q t))
       (along-coordinates forces r t (q t))))
