#lang racket/base
;; Integrals of functions made by the generic arithmetic.
;;
;; Within a derivative the integrand, or a limit, may be a dual number.
;; Integration is linear, so the integral of f + f' ε is that of f plus ε times
;; that of f'; and at a limit b + b' ε it is the integral up to b plus f(b) b' ε.

(require "dual.rkt" "extract.rkt" "number.rkt"
         "../generic/arithmetic.rkt"
         (prefix-in numeric: "../numeric/quadrature.rkt"))

(provide definite-integral integrate)

;; The integral of a function of one variable, to a tolerance relative to the
;; integral of its absolute value.
(define (definite-integral f low high [tolerance 1e-10])
  (check-function-of-one-variable 'definite-integral f)
  (integrate 'definite-integral f low high tolerance))

;; The same on behalf of `who`.
(define (integrate who f low high tolerance)
  (cond
    [(dual? low) (g:- (integrate who f (base low) high tolerance) (edge f low))]
    [(dual? high) (g:+ (integrate who f low (base high) tolerance) (edge f high))]
    [else (integrate-between who f (number who low) (number who high) tolerance)]))

(define (base limit) (primal-part limit (dual-tag limit)))

;; What the ε of a limit adds.
(define (edge f limit)
  (define tag (dual-tag limit))
  (g:* (f (base limit)) (make-dual tag 0 (tangent-part limit tag))))

;; Between numbers.  Where f turns out to be dual, its parts are integrated one
;; after the other.
(define (integrate-between who f low high tolerance)
  (define (integral g) (integrate-between who g low high tolerance))
  (define result
    (let/ec stop
      (define (sample x)
        (define y (f x))
        (cond [(real? y) y]
              [(dual? y) (stop y)]
              [else (number who y)]))
      (numeric:quadrature sample low high #:tolerance tolerance #:name who)))
  (cond
    [(dual? result)
     (define tag (dual-tag result))
     (g:+ (integral (lambda (x) (without-tag tag (f x))))
          (g:* (integral (lambda (x) (extract-tangent tag (f x)))) (perturb tag 0)))]
    [else result]))

;; x with the ε of this tag set to 0.
(define (without-tag tag x)
  (cond [(not (dual? x)) x]
        [(eqv? (dual-tag x) tag) (primal-part x tag)]
        [else
         (define t (dual-tag x))
         (make-dual t (without-tag tag (primal-part x t)) (without-tag tag (tangent-part x t)))]))
