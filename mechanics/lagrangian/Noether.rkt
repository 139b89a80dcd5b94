#lang racket/base
;; Noether's theorem (SICM 1.8.5, pp. 90–91).
;;
;; Let F̃(s) be a family of coordinate transformations with F̃(0) the identity, s one
;; parameter or several.  If L ∘ C̃(s) = L for all s, C̃(s) being the transformation of
;; local tuples that goes with F̃(s), then along every motion
;;
;;   I = ∂₂L · DF̃(0)
;;
;; is constant, a component for each parameter.

(require "Lagrange-equations.rkt" "local-tuple.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../value/structure.rkt")

(provide Noether-integral)

;; ((Noether-integral L F-tilde) local): a scalar for one parameter, a down tuple for
;; several.
(define-printed (Noether-integral L F-tilde)
  (check-Lagrangian 'Noether-integral L)
  (define n (parameter-count F-tilde))
  (define P ((partial 2) (scalar-valued 'Noether-integral L)))
  (lambda (local)
    (define momenta (P local))
    (define integrals
      (for/list ([k (in-range n)])
        (g:* momenta (derivative-at (lambda (s) (moved F-tilde n k s local)) 0))))
    (if (= n 1) (car integrals) (list->down integrals))))

;; The coordinates when the parameter k of n is s and the others are 0.
(define (moved F-tilde n k s local)
  (define F (apply F-tilde (for/list ([i (in-range n)]) (if (= i k) s 0))))
  (unless (procedure? F)
    (complain 'Noether-integral
              (string-append "the family ~a gives no coordinate transformation, "
                             "a function of the local tuple, but ~a")
              (value->text F-tilde) (describe-with-value F)))
  (define q (F local))
  (unless (same-shape? q (coordinate local))
    (complain 'Noether-integral "the family ~a gives ~a where the coordinates are ~a"
              (value->text F-tilde) (describe-with-value q)
              (describe-with-value (coordinate local))))
  q)

;; The number of parameters that the family takes, the least if it leaves a choice.
(define (parameter-count F-tilde)
  (define least
    (for/first ([n (in-range 1 100)] #:when (takes-arguments? F-tilde n)) n))
  (unless least
    (complain-of-argument
     'Noether-integral
     "a family of coordinate transformations: a function of its parameters" F-tilde))
  least)
