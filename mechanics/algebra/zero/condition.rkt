#lang racket/base
;; Conditions for a residual to vanish: factor × core, and equations for parameters.
;;
;; Every factor of the numerator is not zero at a generic point; the *core* is
;; the one that can vanish by a choice of parameters: a relation between
;; parameters alone, if there is one, else the largest factor.  Under assumptions,
;; a factor with a known sign cannot vanish.
;;
;; A core that moves, with a time t say, vanishes at all times if its coefficients
;; along sin ωt, cos ωt, t ... do: each may give an equation.

(require racket/list
         "readable-equation.rkt"
         "../expression/read.rkt" "../expression/substitute.rkt"
         "../field/field.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/present.rkt"
         "../simplify/simplify-expression.rkt")

(provide factor-and-core)

;; variables : symbols that are no parameters
;; may-vanish? : expression -> boolean
;; -> factor core conditions: the value is factor · core; conditions are equations
;; (= expression expression), as data, which together make the core 0; there may be
;; none.
(define (factor-and-core F f variables may-vanish?)
  (define (parameter? e) (constant-expression? e variables))
  (define core
    (choose-core F (vanishing-factors F (fraction-numerator f) may-vanish?) parameter?))
  (cond [core
         (define-values (factor p)
           (with-flonums-in-core
            F f (presentable-sign F (fraction-from-poly (field-ring F) core))))
         (values (present F factor)
                 (present F p)
                 (conditions F core parameter? may-vanish?))]
        [else (values (present F f) 1 '())]))

;; -> f/p and p, or multiples of them with the product f.  A flonum is a whole number
;; over a power of 2, which the parts of f do not show: where there are flonums, their
;; common content goes to the core, which gives its terms the numbers they have in f.
(define (with-flonums-in-core F f p)
  (define R (field-ring F))
  (define factor (fraction/ R f p))
  (define content (poly-content (fraction-numerator factor)))
  (if (field-inexact? F)
      (values (fraction-scale R (/ 1 content) factor) (fraction-scale R content p))
      (values factor p)))

;; Factors of p with several terms that may be zero: its parts as they are found at once, then
;; their factors; parts with too many terms are not factored.
(define (vanishing-factors F p may-vanish?)
  (define R (field-ring F))
  (define (may-be? g) (and (> (poly-term-count g) 1) (may-vanish? (present-poly F g))))
  (define parts (filter may-be? (map power-base (poly-parts R p))))
  (append parts
          (for*/list ([g (in-list parts)]
                      [h (in-list (irreducible R g))]
                      #:unless (equal? g h)
                      #:when (may-be? h))
            h)))

;; The polynomial or its negative, whichever has its first term positive.
(define (presentable-sign F p)
  (if (negative? (caar (linear-terms F p)))
      (fraction-negate (field-ring F) p)
      p))

;; The first that is a relation between symbols, or between parameters, else the
;; one with most terms; #f of none.
(define (choose-core F candidates parameter?)
  (define (related? kind?) (lambda (p) (and (all-kernels? F p kind?) (relation-for F p) p)))
  (or (ormap (related? (lambda (e) (and (symbol? e) (parameter? e)))) candidates)
      (ormap (related? parameter?) candidates)
      (for/fold ([best #f]) ([p (in-list candidates)])
        (if (and best (>= (poly-term-count best) (poly-term-count p))) best p))))

;; ---------------------------------------------------------------------------
;; Conditions

;; More equations than these tell nobody anything.
(define equation-limit 3)

(define (conditions F p parameter? may-vanish?)
  (define coefficients (moving-coefficients F p parameter?))
  (define equations
    (for/list ([c (in-list coefficients)]) (condition F c parameter? may-vanish?)))
  (define found (remove-duplicates (filter values equations)))
  (if (and (<= (length found) equation-limit)
           (for/and ([c (in-list coefficients)] [e (in-list equations)])
             (or e (follows? (present-poly F c) found))))
      found
      '()))

;; Does an expression vanish where the equations that give symbols hold?
(define (follows? e equations)
  (define values-of-symbols
    (for/list ([q (in-list equations)] #:when (symbol? (cadr q)))
      (cons (cadr q) (datum->expression (caddr q)))))
  (and (pair? values-of-symbols)
       (eqv? 0 (simplify-expression (substitute-expression e values-of-symbols)))))

;; An equation that makes a polynomial in parameters vanish, or #f.
(define (condition F p parameter? may-vanish?)
  (define core (choose-core F (vanishing-factors F p may-vanish?) parameter?))
  (and core (relation-for F core)))
