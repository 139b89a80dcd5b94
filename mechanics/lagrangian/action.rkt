#lang racket/base
;; The action of a path: ∫ L ∘ Γ[q] from t₁ to t₂ (SICM 1.4, p. 17).

(require "local-tuple.rkt" "Lagrange-equations.rkt"
         "../generic/function.rkt" "../generic/describe.rkt"
         "../algebra/expression.rkt"
         (prefix-in numeric: "../numeric/quadrature.rkt")
         (prefix-in numeric: "../numeric/minimize.rkt"))

(provide Lagrangian-action definite-integral minimize)

(define (Lagrangian-action L q t1 t2 [tolerance 1e-10])
  (check-Lagrangian 'Lagrangian-action L)
  (define along (Gamma (path 'Lagrangian-action q)))
  (define value (scalar-valued 'Lagrangian-action L))
  (integrate 'Lagrangian-action (lambda (t) (value (along t))) t1 t2 tolerance))

;; The integral of a function of one variable, to a tolerance relative to the
;; integral of its absolute value.
(define (definite-integral f low high [tolerance 1e-10])
  (check-integrand 'definite-integral f)
  (integrate 'definite-integral f low high tolerance))

(define (integrate who f low high tolerance)
  (numeric:quadrature (numeric-valued who f) (number who low) (number who high)
                      #:tolerance tolerance #:name who))

;; (argument value steps) of a minimum of f between low and high (SICM p. 19).
(define (minimize f low high #:tolerance [tolerance 1e-8])
  (check-integrand 'minimize f)
  (numeric:minimize (numeric-valued 'minimize f) (number 'minimize low) (number 'minimize high)
                    #:tolerance tolerance))

;; ---------------------------------------------------------------------------
;; Numbers only

(define (numeric-valued who f)
  (lambda (x)
    (define y (f x))
    (if (real? y) y (number who y))))

(define (number who x)
  (cond [(real? x) x]
        [else
         (raise
          (exn:fail:contract
           (format "~a: expected a real number; given ~a~a" who (describe-with-value x)
                   (if (symbolic? x)
                       "\n  give its symbols values first: (substitute expression 'm 3 ...)"
                       ""))
           (current-continuation-marks)))]))

(define (check-integrand who f)
  (unless (and (procedure? f) (accepts? f 1))
    (raise-argument-error who "a function of one variable" f)))
