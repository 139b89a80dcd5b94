#lang racket/base
;; The domain of a question: where all that it speaks of has a real value.
;;
;; L = v²/2 − log(x − 2) has no value where the path x = 1 is, though the residual has one.  So
;; the domain is a list of expressions beside the residual: the Lagrangian along the path, the
;; path, a quantity.  They stay as they were given, as log(1 − 2) would become a complex number.
;; An expression that holds a number that is not real, as e^(it), has complex values, and is left
;; out.

(require racket/list
         "existence.rkt"
         "../assumption/assumption-set.rkt" "../assumption/domain.rkt"
         "../assumption/reference-point.rkt" "../assumption/signs.rkt"
         "../expression/expression.rkt" "../expression/flat-graph.rkt"
         "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/declare-relations.rkt" "../simplify/known-sign.rkt"
         "../simplify/simplify-expression.rkt")

(provide domain-expressions in-place-of somewhere-real? part-without-value unexpected-domain)

;; xs : values -> those of the expressions among them that may lack a real value somewhere
(define (domain-expressions xs)
  (filter partial? (remove-duplicates xs eq?)))

(define (partial? x)
  (and (node? x)
       (all-numbers-real? x)
       (not (everywhere-defined? (expression->plain-tape x)))))

(define (all-numbers-real? e)
  (all-leaves? (lambda (leaf) (or (symbol? leaf) (rational? leaf))) e))

;; e with expressions in place of symbols, nothing being evaluated
(define (in-place-of replacements e) (substitute-expression e replacements make-node))

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
