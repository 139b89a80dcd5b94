#lang racket/base
;; The Hamilton–Jacobi equation (SICM 6.1, pp. 411–425).
;;
;; A generating function F₂(t, q, p') = S makes the new Hamiltonian vanish, so that the new state
;; rests, if
;;
;;     ∂₀S + H(t, q, ∂₁S) = 0.
;;
;; S may hold constants, as many as there are coordinates: the new momenta.  Without explicit
;; time S = W(q) − E t.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/generic-state.rkt"
         "../value/shape.rkt"
         "../verdict/question-domain.rkt" "../verdict/surveyed-zero.rkt")

(provide Hamilton-Jacobi-residual verify-Hamilton-Jacobi)

;; ((Hamilton-Jacobi-residual H S) t q)
(define (Hamilton-Jacobi-residual H S)
  (define who 'Hamilton-Jacobi-residual)
  (check-both who H S)
  (make-function (residual who H S) 4 (call-datum who H S)))

(define (residual who H S)
  (define (value-at t q)
    (check-scalar-value who "Hamilton's principal function" S (S t q))
    (define state (up t q (derivative-at (lambda (q) (S t q)) q)))
    (check-H-state who state)
    (g:+ (derivative-at (lambda (t) (S t q)) t) (H state)))
  (procedure-rename value-at who))

;; The verdict at a time and coordinates that are symbols.
(define (verify-Hamilton-Jacobi H S t q)
  (define who 'verify-Hamilton-Jacobi)
  (check-both who H S)
  (check-symbols who (up t q) "time and coordinates")
  (prove-residual-zero (lambda () ((residual who H S) t q)) (scalars (up t q))
                       #:domain (lambda () (domain H S t q))
                       #:within (lambda () (expressions-of (S t q)))
                       #:again (lambda (change)
                                 (verify-Hamilton-Jacobi (change H) (change S) t q))))

;; H has a value where its momenta are ∂S
(define (domain H S t q)
  (define momenta (derivative-at (lambda (q) (S t q)) q))
  (append (expressions-of (S t q)) (values-along (list H) (up t q momenta))))

(define (check-both who H S)
  (when (and (procedure? H) (procedure? S) (accepts? H 2) (not (accepts? H 1)) (accepts? S 1))
    (complain who "the Hamiltonian comes first, then the principal function: (~a H S); given ~a, ~a"
              who (value->text H) (value->text S)))
  (check-Hamiltonian who H)
  (check-takes who S 2
               "Hamilton's principal function takes the time and the coordinates, (S t q)"))
