#lang racket/base
;; A value as one quotient in lowest terms.
;;
;; The reduced fraction of the normal form has no common divisor above and
;; below.  Numbers, and kernels that every term of the numerator has, stand in
;; front; so do powers of roots, which a reduced denominator cannot hold, taken
;; back from it.

(require racket/list
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt"
         "../field/field.rkt"
         "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt"
         "../presentation/form.rkt" "../presentation/fraction-pieces.rkt"
         "../presentation/present.rkt"
         "../presentation/term.rkt"
         "../simplify/simplify-expression.rkt")

(provide together-expression numerator-and-denominator
         quotient-expression expression->form flatten-products terms-as-presented)

;; -> expression and assumptions
(define (together-expression e [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (values (quotient-expression F f) assumptions))

(define (quotient-expression F f)
  (define c (fraction-number f))
  (if c
      (present-number c (field-inexact? F))
      (flatten-products (form-expression (quotient-form F f)))))

;; -> two expressions, whose quotient e is, and assumptions
(define (numerator-and-denominator e [A no-assumptions])
  (define-values (whole assumptions) (together-expression e A))
  (cond [(headed? whole op:/)
         (values (car (node-args whole)) (cadr (node-args whole)) assumptions)]
        [else (values whole 1 assumptions)]))

;; ---------------------------------------------------------------------------
;; The quotient

(define (quotient-form F f)
  (define p (fraction->piece F f))
  (define-values (c powers core) (split-numerator F (piece-numerator p)))
  (define sign (if (and core (all-negative? F core)) -1 1))
  (fraction-form F
                 (* sign c)
                 (collect-powers (append powers (piece-powers p)))
                 (if core
                     (list (expression->form
                            (present-poly F (poly-scale (field-ring F) sign core))))
                     '())
                 (for/list ([h (in-list (piece-factors p))])
                   (cons (expression->form (present-poly F (car h))) (cdr h)))))

;; c · powers · sums / divisors, the denominator of c below.
(define (fraction-form F c powers sums divisors)
  (define n (if (field-inexact? F) 1 (denominator c)))
  (if (eqv? n 1)
      (product-form c powers sums divisors (field-inexact? F))
      (product-form (* c n) powers sums (cons (cons (expression->form n) 1) divisors) #f)))

;; -> number, powers and the polynomial that is left, #f for 1.
(define (split-numerator F p)
  (define R (field-ring F))
  (define content (if (or (field-inexact? F) (poly-zero? p)) 1 (poly-content p)))
  (define monomial (common-monomial R p))
  (define rest (divide-by-monomial R (poly-scale R (/ 1 content) p) monomial))
  (define powers (kernel-powers F (monomial-factors R monomial)))
  (if (poly-constant? rest)
      (values (* content (poly-constant-value rest)) powers #f)
      (values content powers rest)))

;; Does every term of the polynomial, as it is presented, have a minus sign?
(define (all-negative? F p) (andmap negative? (map car (terms-as-presented F p))))

;; ((number . expression) ...)
(define (terms-as-presented F p) (linear-terms F (fraction-from-poly (field-ring F) p)))

;; ---------------------------------------------------------------------------
;; Expressions as forms

;; A leading minus becomes the form's sign.  Nothing is chosen by size here, so the
;; form has none.
(define (expression->form e)
  (define opposite (and (negative-expression? e) (negated e)))
  (form 0
        (if opposite -1 1)
        (lambda (sign)
          (cond [opposite (if (eqv? sign 1) opposite e)]
                [else (if (eqv? sign 1) e (e:negate e))]))))

(define (negative-expression? e)
  (cond [(number? e) (and (real? e) (negative? e))]
        [(or (headed? e op:*) (headed? e op:/)) (negative-expression? (car (node-args e)))]
        [else #f]))

;; The opposite of a negative number, product or quotient.
(define (negated e)
  (cond [(number? e) (- e)]
        [(headed? e op:/)
         (make-node op:/ (list (negated (car (node-args e))) (cadr (node-args e))))]
        [else
         (product-expression 1 (cons (negated (car (node-args e))) (cdr (node-args e))))]))

;; Products within the product, or within those of the quotient, made part of it.
(define (flatten-products e)
  (cond [(headed? e op:/) (make-node op:/ (map flatten-products (node-args e)))]
        [(headed? e op:*)
         (define factors
           (for/list ([a (in-list (node-args e))])
             (define flat (flatten-products a))
             (operands-of flat op:*)))
         (number-first (append* factors))]
        [else e]))

(define (number-first factors)
  (define c (for/product ([a (in-list factors)] #:when (number? a)) a))
  (product-expression c (filter-not number? factors)))
