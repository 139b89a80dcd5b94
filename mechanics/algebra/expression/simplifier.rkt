#lang racket/base
;; The simplifier, as the rooms below it know it.
;;
;; Kernels are found with their arguments simplified, and signs by the terms and
;; factors of an expression: work of the simplifier (simplify/simplifier-workspace.rkt), which
;; stands above both.  It hands itself down, with its methods in one record.

(provide (struct-out simplifier) (struct-out methods) left-unexpanded?
         simplifier-simplify simplifier-terms simplifier-linear-parts
         simplifier-factors simplifier-irreducible-factors simplifier-split-root)

;; ledger : the grounds of the work (assumption/ledger.rkt)
;; fuel : the cost allowed altogether (field/work-bounds.rkt)
(struct simplifier (methods ledger fuel) #:authentic)

;; Procedures that take the simplifier first.
(struct methods (simplify terms linear-parts factors irreducible-factors split-root)
  #:authentic)

;; Besides assumptions it rests on, simplification tells parts (left-unexpanded e) that would have
;; grown too large.
(define (left-unexpanded? note) (eq? (car note) 'left-unexpanded))

(define-syntax-rule (define-method (name s argument ...) method)
  (define (name s argument ...) ((method (simplifier-methods s)) s argument ...)))

;; -> the simplified expression
(define-method (simplifier-simplify s e) methods-simplify)

;; -> ((number . expression) ...), whose sum e is; the numbers are flonums if they
;; came from flonums
(define-method (simplifier-terms s e) methods-terms)

;; -> the same, of terms that add up as values do: those of a sum are the sums of those
;; of its operands
(define-method (simplifier-linear-parts s e) methods-linear-parts)

;; -> number and ((expression . integer) ...), whose product e is; the expressions
;; have a positive leading coefficient
(define-method (simplifier-factors s e) methods-factors)

;; -> the same, of factors that cannot be factored further
(define-method (simplifier-irreducible-factors s e) methods-irreducible-factors)

;; -> outer and ((inner . rational) ...), the root of this degree being
;; outer ∏ inner^rational
(define-method (simplifier-split-root s e degree) methods-split-root)
