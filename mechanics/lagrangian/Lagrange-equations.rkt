#lang racket/base
;; Lagrange's equations as a residual along a path.
;;
;;   D(∂₂L ∘ Γ[q]) − ∂₁L ∘ Γ[q] − Q ∘ Γ[q]                 (SICM 1.5, p. 33)
;;
;; vanishes exactly when q is a path the system can take.  For a Lagrangian
;; that depends on derivatives up to order n it is
;;
;;   Σ_{k=1..n} (−1)^{k+1} D^k(∂_{k+1}L ∘ Γ[q]) − ∂₁L ∘ Γ[q] − Q ∘ Γ[q]
;;
;; (exercises 1.10 and 1.13).  Q is the force outside L; a dissipation function F
;; adds −∂₂F to it.

(require "external-force.rkt" "local-tuple.rkt" "function-of-momenta.rkt" "several-paths.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../generic/multiplied-function.rkt"
         "../generic/up-down.rkt"
         "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         (only-in "../value/compose.rkt" compose))

(provide Lagrange-equations
         equations? equations-Lagrangian equations-force equations-order
         check-Lagrangian check-order scalar-valued)

(define kind:equations
  (make-kind #:rank rank:function
             #:describe (lambda (e) "a function of paths")
             #:datum equations->datum
             #:arity (lambda (e) 2)))

;; A function of paths that keeps its Lagrangian, force and order, for derivations.
(value-struct equations (Lagrangian force order)
  #:kind kind:equations
  #:property prop:procedure
  (case-lambda [(e q) (residual-along e q)]
               [(e . arguments) (raise-one-path e arguments)]))

(define (equations->datum e)
  (append (list 'Lagrange-equations (value->datum (equations-Lagrangian e)))
          (force->datum (equations-force e))
          (if (= (equations-order e) 1) '() (list '#:order (equations-order e)))))

;; ((Lagrange-equations L) q) is the residual, a function of time.
(define (Lagrange-equations L [dissipation #f] #:force [Q #f] #:order [n 1])
  (check-Lagrangian 'Lagrange-equations L)
  (check-order 'Lagrange-equations n)
  (equations L (external-force 'Lagrange-equations Q dissipation) n))

(define (check-order who n)
  (check-argument who exact-positive-integer? n "an order, a positive integer"))

(define (residual-along e q)
  (define L (scalar-valued 'Lagrange-equations (equations-Lagrangian e)))
  (define n (equations-order e))
  (define local (Gamma (path 'Lagrange-equations q) (+ n 2)))
  (define force (equations-force e))
  (unary-function (lambda () (value->datum (list e q))) (t)
    (check-time-of-path 'Lagrange-equations q t (along e))
    (define momenta (momentum-terms L local n t))
    (define residual (g:- momenta (((partial 1) L) (local t))))
    (if force
        (g:- residual (force-like 'Lagrange-equations momenta (force (local t))))
        residual)))

;; Σ_{k=1..n} (−1)^{k+1} D^k(∂_{k+1}L ∘ Γ[q]) at t
(define (momentum-terms L local n t)
  (for/fold ([sum 0]) ([k (in-range 1 (add1 n))])
    (define along (compose ((partial (add1 k)) L) local))
    (define term (((g:expt D k) along) t))
    (if (odd? k) (g:+ sum term) (g:- sum term))))

;; ---------------------------------------------------------------------------
;; Bad paths

(define (raise-one-path e arguments)
  (define given (length arguments))
  (complain-of-arity 'Lagrange-equations "the equations take one argument, a path, but got ~a~a"
                     given
                     (cond [(< given 2) ""]
                           [(andmap pointwise? arguments) (one-path-hint arguments (along e))]
                           [(> given 2) ""]
                           [else (format "; the time comes next: (~a ~a)"
                                         ((along e) (argument->text (car arguments)))
                                         (argument->text (cadr arguments)))])))

;; text of a path -> text of the residual along it
(define ((along e) path) (format "(~a ~a)" (value->text e) path))

(define (argument->text x)
  (string-append (if (symbol? x) "'" "") (value->text x)))

;; ---------------------------------------------------------------------------
;; Bad Lagrangians

(define (check-Lagrangian who L)
  (cond [(or (not (procedure? L)) (tuple? L))
         (complain who "a Lagrangian is a function of the local tuple (up t q v); given ~a~a"
                   (describe-with-value L) (quoted-name-hint L))]
        [(of-momenta? L) (raise-of-momenta who L)]
        [(not (accepts? L 1))
         (complain who
                   (string-append "a Lagrangian takes one argument, the local tuple, "
                                  "but ~a does not.~a"
                                  "\n  If it takes parameters first, supply them: (~a (~a ...))")
                   (value->text L)
                   (if (accepts? L 3)
                       (string-append "\n  If it takes the time, coordinates and velocities, "
                                      "write them as one argument: (up t q v)")
                       "")
                   who (value->text L))]))

;; L, whose value is checked to be a number.
(define ((scalar-valued who L) local)
  (check-scalar-value who "a Lagrangian" L (L local) not-scalar-hint))

(define (not-scalar-hint value)
  (cond [(not (pointwise? value)) ""]
        [(equal? (multiplied-hint value) "")
         "\n  was a parameter left out, as the mass in (L-free-particle 'm)?"]
        [else (multiplied-hint value)]))
