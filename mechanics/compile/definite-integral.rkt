#lang racket/base
;; Definite integrals (SICM p. 17).  An integrand that is evaluated often is compiled.

(require "../generic/on-demand.rkt")

(require-on-demand
 ["one-variable.rkt" compile-scalar]
 ["../calculus/integral.rkt" [integrate generic:integrate]])

(provide definite-integral definite-integral-with-tolerance integrate)

;; tolerance : relative to the integral of |f|
;; report    : receives the value, a bound of its error, the number of evaluations
(define (definite-integral f low high [tolerance 1e-10] #:report [report first-of-three])
  (integrate 'definite-integral f low high tolerance #:report report))

(define (definite-integral-with-tolerance f low high tolerance #:report [report first-of-three])
  (integrate 'definite-integral-with-tolerance f low high tolerance #:report report))

;; The same on behalf of `who`.
(define (integrate who f low high tolerance #:report [report first-of-three])
  (generic:integrate who f low high tolerance compile-scalar report))

(define (first-of-three value bound count) value)
