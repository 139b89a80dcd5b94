#lang racket/base
;; The coefficient of an ε in a value of any shape.
;;
;; The value may be a function, run only later, when its argument may carry the
;; very ε that is to be extracted from its value: the derivative of
;; x ↦ (y ↦ ...) applied to itself, say (Manzyuk et al., arXiv:1211.4892).
;; Extraction therefore renames that ε in the arguments for as long as the
;; function runs.  To rename within a function is to rename in its values, after
;; shielding its arguments in the same way.

(require "containers.rkt" "dual.rkt" "perturbed-value.rkt"
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../value/operator.rkt")

(provide extract extract-tangent)

;; The first derivative: the coefficient of the ε of a dual number.
(define (extract-tangent tag x) (extract 'D tag dual-tangent x))

;; pick : perturbed value with this tag -> its part asked for, linear in it
;; operator : the name of the operation on a function, for printing
(define (extract operator tag pick x)
  (define (from x)
    (cond [(perturbed? x) (from-perturbed x)]
          [(constant? x) 0]
          [else (map-leaves from-leaf x)]))
  (define (from-leaf x)
    (cond [(perturbed? x) (from-perturbed x)]
          [(constant? x) 0]
          [(procedure? x) (shielding tag x from (lambda () (list operator (value->datum x))))]
          [else (raise-no-derivative x)]))
  (define (from-perturbed x)
    (define t (perturbed-tag x))
    (cond [(eqv? t tag) (pick x)]
          [(< t tag) 0]
          [else ((parts-map (parts-of x)) from x)]))
  (from x))

(define (constant? x) (or (expression? x) (other-number? x)))

(define (raise-no-derivative x)
  (complain 'D "the function returned a value that has no derivative: ~a~a"
            (describe-with-value x) (list-hint x)))

;; ---------------------------------------------------------------------------
;; Renaming

;; x with one ε replaced by another.
(define (rename-tag old new x)
  (define (rename x)
    (cond [(constant? x) x]
          [(pair? x) (cons (rename (car x)) (rename (cdr x)))]
          [else (map-leaves rename-leaf x)]))
  (define (rename-leaf x)
    (cond [(perturbed? x) (rename-perturbed x)]
          [(plain-function? x)
           (if (closed? x) x (shielding old x rename (lambda () (value->datum x))))]
          [else (map-contents rename restore x)]))
  (define (restore x) (rename-tag new old x))
  (define (rename-perturbed x)
    (define t (perturbed-tag x))
    ((parts-retag (parts-of x)) (if (eqv? t old) new t) rename x))
  (rename x))

;; A parameter, and a structure that shows its fields, are treated as containers.
(define (plain-function? x)
  (and (procedure? x)
       (or (has-kind? x) (not (or (parameter? x) (struct? x))))))

(define (closed? f) (and (has-kind? f) (kind-closed? (kind-of f))))

;; `change` after f, on arguments in which another ε stands for this one
;; meanwhile; an operator if f is one.
(define (shielding tag f change make-datum)
  (define (call keywords values args)
    (define shield (fresh-tag))
    (define (shielded xs) (for/list ([x (in-list xs)]) (rename-tag tag shield x)))
    (define value
      (if (null? keywords)
          (apply f (shielded args))
          (keyword-apply f keywords (shielded values) (shielded args))))
    (rename-tag shield tag (change value)))
  (define procedure
    (if (takes-keywords? f)
        (make-keyword-procedure
         (lambda (keywords values . args) (call keywords values args)))
        (lambda args (call '() '() args))))
  (if (operator? f)
      (make-primitive-operator procedure make-datum)
      (make-function procedure (arity-mask f) make-datum)))

(define (takes-keywords? f)
  (define-values (required allowed) (procedure-keywords f))
  (not (null? allowed)))
