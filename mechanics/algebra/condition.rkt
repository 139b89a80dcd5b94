#lang racket/base
;; What makes a residual vanish: factor × core, and an equation for a parameter.
;;
;; Every factor of the numerator is not zero at a generic point; the *core* is
;; the one that can vanish by a choice of parameters: a polynomial in symbols
;; alone, if there is one, else the largest factor.  Under assumptions, what has a
;; sign cannot vanish.

(require "expression.rkt" "kernel.rkt" "field.rkt" "present.rkt"
         "polynomial/polynomial.rkt" "polynomial/fraction.rkt")

(provide factor-and-core)

;; may-vanish? : expression -> boolean
;; -> factor core condition: the value is factor · core; condition is #f or an
;; equation (= symbol expression), as a datum, equivalent to core = 0.
(define (factor-and-core F f may-vanish?)
  (define R (field-ring F))
  (define (candidate? g)
    (and (eqv? (cdr g) 1)
         (> (poly-term-count (car g)) 1)
         (may-vanish? (present F (fraction-from-poly R (car g))))))
  (define factors (filter candidate? (poly-parts R (fraction-numerator f))))
  (define core (choose-core F (map car factors)))
  (cond [core
         (define p (presentable-sign F (fraction-from-poly R core)))
         (values (present F (fraction/ R f p))
                 (present F p)
                 (condition F core))]
        [else (values (present F f) 1 #f)]))

;; The polynomial or its negative, whichever has its first term positive.
(define (presentable-sign F p)
  (if (negative? (car (car (linear-terms F p))))
      (fraction-negate (field-ring F) p)
      p))

;; Of factors with several terms: the first that is a relation between parameters,
;; else the one with most terms.
(define (choose-core F candidates)
  (or (for/first ([p (in-list candidates)] #:when (condition F p)) p)
      (for/fold ([best #f]) ([p (in-list candidates)])
        (if (and best (>= (poly-term-count best) (poly-term-count p))) best p))))

;; The polynomial solved for a symbol in which it is linear, the coefficient
;; being a number or, failing that, a monomial.
(define (condition F p)
  (define variables (poly-variables (field-ring F) p))
  (define (symbolic-variable? i)
    (symbol? (kernel-expression (vector-ref (field-kernels F) i))))
  (and (andmap symbolic-variable? variables)
       (or (for/or ([i (in-list variables)]) (solve-for F p i poly-constant?))
           (for/or ([i (in-list variables)]) (solve-for F p i monomial?)))))

(define (monomial? p) (eqv? (poly-term-count p) 1))

(define (solve-for F p i simple?)
  (define R (field-ring F))
  (define cs (poly-coefficients R p i))
  (and (eqv? (caar cs) 1)
       (simple? (cdar cs))
       (let* ([rest (if (null? (cdr cs)) (poly-constant R 0) (cdadr cs))]
              [value (fraction/ R (fraction-from-poly R (poly-negate R rest))
                                (fraction-from-poly R (cdar cs)))])
         (list '=
               (kernel-expression (vector-ref (field-kernels F) i))
               (expression->datum (present F value))))))
