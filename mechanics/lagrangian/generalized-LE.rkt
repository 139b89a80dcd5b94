#lang racket/base
;; Lagrange's equations of a Lagrangian that depends on higher derivatives (SICM, exercise
;; 1.10), of a path, or of a local tuple.
;;
;; At a local tuple (t, q, v, a, ...) with an even number of components, 2n + 2, they are of
;; order n.  The osculating path has these derivatives there, and the residual depends on no
;; others, so that the residual of the path is that of the local tuple.

(require "coordinate-transformation.rkt" "Lagrange-equations.rkt" "local-tuple.rkt"
         "../generic/define-plain.rkt" "../generic/wrong-argument.rkt"
         "../value/structure.rkt")

(provide generalized-LE)

;; n : the order for paths; the length of a local tuple determines the order there
(define-plain (generalized-LE L #:order [n 2]) (equations-of-either L n residual-at))

(define (residual-at L local)
  (define n (- (quotient (s:length local) 2) 1))
  (unless (and (even? (s:length local)) (positive? n))
    (complain-of-argument 'generalized-LE
                          (string-append "a path or a local tuple of 4 or 6 or ... components: "
                                         "(up t q v a)")
                          local))
  (((Lagrange-equations L #:order n) (osculating-path local)) (time local)))
