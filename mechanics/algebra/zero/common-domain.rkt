#lang racket/base
;; The domain of a question: where all that it speaks of has a real value.
;;
;; L = v²/2 − log(x − 2) has no value where the path x = 1 is, though the residual has one.  So
;; the domain is a list of expressions beside the residual (existence.rkt): the Lagrangian along
;; the path, the path, a quantity.

(require racket/list
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt"
         "../assumption/reference-point.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt" "../expression/symbols.rkt"
         "../simplify/declare-relations.rkt" "../simplify/known-sign.rkt"
         "../simplify/simplify-expression.rkt")

(provide somewhere-real? part-without-value unexpected-domain)

;; Have all of es a real value at some point where A holds?
(define (somewhere-real? es A)
  (or (null? es) (and (find-reference '() (struct-copy assumptions A [domain es])) #t)))

;; -> the smallest part without a real value, or #f if there is a point where all have one
(define (part-without-value es A)
  (define alone (findf (lambda (e) (not (somewhere-real? (list e) A))) es))
  (cond [(not alone) (and (not (somewhere-real? es A)) (make-node op:up es))]
        [else
         (let smallest ([e alone])
           (define args (if (node? e) (node-args e) '()))
           (define part (findf (lambda (a) (not (somewhere-real? (list a) A))) args))
           (if part (smallest part) e))]))

;; Relations, as datums, that hold where e has a real value, and nowhere where all its symbols are
;; positive: c ≤ 0 of √(−c).  A reader who thinks of positive numbers would not expect them.
(define (unexpected-domain e A)
  (define needs (if (node? e) (domain-relations e) '()))
  (define B
    (if (null? needs)
        A
        (with-relations A (for/list ([s (in-list (symbols-in e))]) `(> ,s 0)))))
  (remove-duplicates
   (for*/list ([r (in-list needs)]
               [sign (in-value (known-sign (relation-expression r) B))]
               #:when (and sign (not (signs-within? (number-signs sign) (relation-signs r)))))
     (list (if (signs-within? zero (relation-signs r)) '>= '>)
           (expression->datum (simplify-expression (relation-expression r) A))
           0))))
