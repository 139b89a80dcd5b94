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
         "../presentation/form.rkt" "../presentation/fraction-pieces.rkt" "../presentation/present.rkt"
         "../presentation/term.rkt"
         "../simplify/simplify-expression.rkt")

(provide together-expression numerator-and-denominator
         quotient-expression expression->form flatten-products polynomial-terms
         inexact-field?)

;; -> expression and assumptions
(define (together-expression e [A no-assumptions])
  (define-values (F f assumptions) (normal-form e A))
  (values (quotient-expression F f) assumptions))

(define (quotient-expression F f)
  (define p (fraction-numerator f))
  (if (and (fraction-polynomial? f) (poly-constant? p))
      (present-number (poly-constant-value p) (inexact-field? F))
      (flatten-products (form-expression (quotient-form F f)))))

;; -> two expressions, whose quotient e is, and assumptions
(define (numerator-and-denominator e [A no-assumptions])
  (define-values (whole assumptions) (together-expression e A))
  (cond [(and (node? whole) (eq? (node-head whole) op:/))
         (values (car (node-args whole)) (cadr (node-args whole)) assumptions)]
        [else (values whole 1 assumptions)]))

;; ---------------------------------------------------------------------------
;; The quotient

;; show : field polynomial -> expression, for numerator and divisors of several
;; terms.
(define (quotient-form F f [show present-polynomial])
  (define p (fraction->piece F f))
  (define-values (c powers core) (split-numerator F (piece-numerator p)))
  (define sign (if (and core (all-negative? F core)) -1 1))
  (fraction-form F
                 (* sign c)
                 (for/fold ([powers powers]) ([q (in-list (piece-powers p))])
                   (multiply-powers powers (list q)))
                 (if core
                     (list (expression->form (show F (poly-scale (field-ring F) sign core))))
                     '())
                 (for/list ([h (in-list (piece-factors p))])
                   (cons (expression->form (show F (car h))) (cdr h)))))

(define (present-polynomial F p) (present F (fraction-from-poly (field-ring F) p)))

;; c · powers · sums / divisors, the denominator of c below.
(define (fraction-form F c powers sums divisors)
  (define n (if (inexact-field? F) 1 (denominator c)))
  (if (eqv? n 1)
      (product-form c powers sums divisors (inexact-field? F))
      (product-form (* c n) powers sums (cons (cons (expression->form n) 1) divisors) #f)))

;; -> number, powers and the polynomial that is left, #f for 1.
(define (split-numerator F p)
  (define R (field-ring F))
  (define content (if (or (inexact-field? F) (poly-zero? p)) 1 (poly-content p)))
  (define exponents (poly-monomial-content R p))
  (define monomial (poly-monomial R 1 exponents))
  (define rest (poly-divide R (poly-scale R (/ 1 content) p) monomial))
  (define powers
    (for/fold ([powers '()]) ([e (in-vector exponents)] [k (in-vector (field-kernels F))]
                              #:unless (eqv? e 0))
      (multiply-powers powers (list (cons k e)))))
  (if (poly-constant? rest)
      (values (* content (poly-constant-value rest)) powers #f)
      (values content powers rest)))

(define (inexact-field? F) (field-inexact? F))

;; Does every term of the polynomial, as it is presented, have a minus sign?
(define (all-negative? F p)
  (for/and ([t (in-list (linear-terms F (fraction-from-poly (field-ring F) p)))])
    (negative? (car t))))

;; The terms of a polynomial, angles left as they are.
(define (polynomial-terms F p)
  (for/list ([t (in-list (poly-terms (field-ring F) p))])
    (make-term (poly-term-coefficient t)
               (for/list ([p (in-list (poly-term-powers t))])
                 (make-power (vector-ref (field-kernels F) (power-base p)) (power-exponent p))))))

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
         (define first (negated (car (node-args e))))
         (define rest (cdr (node-args e)))
         (cond [(not (eqv? first 1)) (make-node op:* (cons first rest))]
               [(null? (cdr rest)) (car rest)]
               [else (make-node op:* rest)])]))

;; Products within the product, or within those of the quotient, made part of it.
(define (flatten-products e)
  (cond [(headed? e op:/) (make-node op:/ (map flatten-products (node-args e)))]
        [(headed? e op:*)
         (define factors
           (for/list ([a (in-list (node-args e))])
             (define flat (flatten-products a))
             (if (headed? flat op:*) (node-args flat) (list flat))))
         (number-first (append* factors))]
        [else e]))

(define (number-first factors)
  (define c (for/product ([a (in-list factors)] #:when (number? a)) a))
  (define others (for/list ([a (in-list factors)] #:unless (number? a)) a))
  (cond [(null? others) c]
        [(not (eqv? c 1)) (make-node op:* (cons c others))]
        [(null? (cdr others)) (car others)]
        [else (make-node op:* others)]))
