#lang racket/base
;; Where the energy goes.
;;
;; Forces Q outside L do work at the rate Q q̇, and L itself may change in time.  So the
;; energy E = ∂₂L q̇ − L changes by
;;
;;   dE/dt = Q q̇ − ∂₀L,
;;
;; and the rest of this balance, along any path, is the residual of Lagrange's
;; equations times q̇.

(require "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt"
         "../lagrangian/energy.rkt" "../lagrangian/external-force.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt")

(provide power-balance)

;; (((power-balance L #:force Q) q) t) : dE/dt − Q q̇ + ∂₀L along q
(define (power-balance L [dissipation #f] #:force [Q #f])
  (define who 'power-balance)
  (check-Lagrangian who L)
  (define outside (external-force who Q dissipation))
  (define rate (Lagrangian->power-loss L))
  (define name (apply call-datum who L (force->datum outside)))
  (unary-function name (given-q)
    (define q (path who given-q))
    (define local (Gamma q))
    (unary-function (lambda () (list (name) (value->datum q))) (t)
      (define state (local t))
      (define work (if outside (power-of who L outside state) 0))
      (g:+ (g:- ((rate q) t) work) (((partial 0) L) state)))))

(define (power-of who L Q state)
  (define force (force-like who (((partial 2) L) state) (Q state)))
  (if (eqv? force 0) 0 (g:* force (velocity state))))
