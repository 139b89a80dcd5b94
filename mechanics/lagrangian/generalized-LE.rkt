#lang racket/base
;; Lagrange's equations of a Lagrangian that depends on higher derivatives (SICM, exercise
;; 1.10), of a path, or of a local tuple.
;;
;; At a local tuple (t, q, v, a, ...) with an even number of components, 2n + 2, they are of
;; order n.  The osculating path has these derivatives there, and the residual depends on no
;; others, so that the residual of the path is that of the local tuple.
;;
;; The sign is that of scmutils: the derivative of the highest order, D^n(∂_{n+1}L), counts as
;; positive.  For even n this is the opposite of the residual of `Lagrange-equations`.

(require "coordinate-transformation.rkt" "Lagrange-equations.rkt" "local-tuple.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt"
         "../generic/printed-function.rkt" "../generic/scalar.rkt" "../generic/wrong-argument.rkt"
         "../value/structure.rkt")

(provide generalized-LE)

;; n : the order for paths; the length of a local tuple determines the order there
(define-plain (generalized-LE L #:order [n 2])
  (check-Lagrangian 'generalized-LE L)
  (check-order 'generalized-LE n)
  (printed-function (generalized-LE L) (q)
    (if (local? q)
        (residual-at L q)
        (signed n ((Lagrange-equations L #:order n) q)))))

(define (signed n residual) (if (even? n) (g:negate residual) residual))

;; Is q a local tuple and no path?  Then its first component is a time.
(define (local? q)
  (and (local-tuple? q) (scalar? (time q))))

(define (residual-at L local)
  (define n (- (quotient (s:length local) 2) 1))
  (unless (and (even? (s:length local)) (positive? n))
    (complain-of-argument 'generalized-LE
                          (string-append "a path or a local tuple of 4 or 6 or ... components: "
                                         "(up t q v a)")
                          local))
  (signed n (((Lagrange-equations L #:order n) (osculating-path local)) (time local))))
