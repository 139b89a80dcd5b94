#lang racket/base
;; Square roots of sums of roots, as they remain when other factors of the radicand are taken
;; out: √(3x - 2√2 x) is (√2 - 1) √x.

(require "../expression/expression.rkt"
         "../field/field.rkt"
         "../kernel/kernel.rkt"
         "../polynomial/polynomial.rkt"
         "../presentation/present.rkt"
         "../radical/radical-expression.rkt")

(provide (struct-out square) as-square)

;; A number is sign · root².
(struct square (sign root) #:authentic)

;; p : polynomial over F -> square, or #f
(define (as-square F p)
  (define e (and (all-roots? F (poly-variables (field-ring F) p)) (present-poly F p)))
  (and e
       (sum? e)
       (for/or ([sign (in-list '(1 -1))])
         (define root (power-of-constant (e:* sign e) 1/2))
         (and root (square sign root)))))

(define (all-roots? F variables)
  (and (pair? variables)
       (for/and ([i (in-list variables)])
         (and (relation-of F i) (root? (kernel-relation (field-kernel F i)))))))
