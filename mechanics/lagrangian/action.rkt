#lang racket/base
;; The action of a path: ∫ L ∘ Γ[q] from t₁ to t₂ (SICM 1.4, p. 17).
;; Of a Lagrangian that depends on derivatives up to order n, ∫ L ∘ Γ[q; n + 2].

(require "Lagrange-equations.rkt" "local-tuple.rkt" "several-paths.rkt" "swapped-arguments.rkt"
         "../compile/definite-integral.rkt" "../generic/define-plain.rkt")

(provide Lagrangian-action)

(define-plain (Lagrangian-action L q t1 t2 [eps 1e-10]
                                 #:tolerance [tolerance eps] #:order [n 1]
                                 #:report [report (lambda (value bound count) value)])
  (check-Lagrangian 'Lagrangian-action L)
  (check-order 'Lagrangian-action n)
  (check-time-of-path 'Lagrangian-action q t1
                      (lambda (q) (format "(Lagrangian-action L ~a t1 t2)" q)))
  (define along (Gamma (path 'Lagrangian-action q) (+ n 2)))
  (define value (scalar-valued 'Lagrangian-action L))
  (with-handlers ([exn:fail:contract?
                   (lambda (e) (check-not-swapped 'Lagrangian-action L q) (raise e))])
    (integrate 'Lagrangian-action (lambda (t) (value (along t))) t1 t2 tolerance
               #:report report)))
