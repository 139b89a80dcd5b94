#lang racket/base
;; The methods of integration, by name and with fixed steps.

(require "method-names.rkt"
         "system/check.rkt"
         "../numeric/ode/bulirsch-stoer.rkt" "../numeric/ode/dormand-prince-54.rkt"
         "../numeric/ode/dormand-prince-853.rkt" "../numeric/ode/gauss-legendre.rkt"
         "../numeric/ode/doubled-runge-kutta.rkt" "../numeric/ode/radau.rkt"
         "../numeric/ode/stepper.rkt" "../numeric/ode/taylor.rkt"
         (rename-in "../numeric/ode/symplectic.rkt" [leapfrog numeric:leapfrog]))

(provide method-of automatic
         leapfrog Yoshida-4 Yoshida-6 Yoshida-8
         Gauss-Legendre-2 Gauss-Legendre-4 Gauss-Legendre-6)

;; Stands for the one that suits a system (choose-method.rkt).
(define automatic (adaptive-method 'auto #f void))

(define adaptive
  (list automatic taylor dormand-prince-853 dormand-prince-54 bulirsch-stoer
        quality-controlled-runge-kutta-4 radau-iia-5))

(define (method-of who m)
  (check-method who m)
  (if (method? m)
      m
      (for/first ([known (in-list adaptive)] #:when (eq? (method-name known) m)) known)))

(define-syntax-rule (define-fixed [name make] ...)
  (begin
    (define (name step)
      (check-positive 'name "time step" step)
      (make (real->double-flonum step))) ...))

(define-fixed
  [leapfrog numeric:leapfrog]
  [Yoshida-4 yoshida-4] [Yoshida-6 yoshida-6] [Yoshida-8 yoshida-8]
  [Gauss-Legendre-2 gauss-legendre-2] [Gauss-Legendre-4 gauss-legendre-4]
  [Gauss-Legendre-6 gauss-legendre-6])
