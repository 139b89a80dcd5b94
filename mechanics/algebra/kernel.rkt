#lang racket/base
;; Kernels: the variables of the polynomials an expression is written in.
;;
;; A kernel is a symbol, a literal function applied, the sine or the cosine of
;; an angle, a root ...: anything the arithmetic takes as a whole.  Some kernels
;; satisfy a relation:
;;
;;     sin²θ = 1 - cos²θ,    sinh²u = cosh²u - 1,    rᵠ = u for r = u^(1/q).
;;
;; A kernel has two places, given when all kernels of an expression are known:
;; its `index` as a variable, which orders the terms of a sum, and its `rank`,
;; which orders the factors of a product.  Symbols come first in both, by the
;; alphabet; after them a sum shows the highest derivatives first, a product
;; last.

(require "expression.rkt" "order.rkt")

(provide (struct-out kernel) make-kernel place-kernels!
         (struct-out circle) (struct-out angle) (struct-out root))

;; relation : #f, or the circle or root this kernel belongs to
(struct kernel (expression relation [index #:mutable] [rank #:mutable])
  #:authentic)

(define (make-kernel expression relation) (kernel expression relation #f #f))

;; The sine and the cosine of a basic angle; hyperbolic ones if sign is -1.
(struct circle (expression sign [sine #:mutable] [cosine #:mutable])
  #:authentic)

;; An angle occurring under a sine or cosine: a linear form over atoms, and how
;; many times each basic angle it is, ((circle . integer) ...).
(struct angle (form [multiples #:mutable])
  #:authentic)

;; The q-th root of a radicand.
(struct root (radicand degree [kernel #:mutable])
  #:authentic)

;; ---------------------------------------------------------------------------

;; Gives every kernel its places; -> the kernels as a vector by index.
(define (place-kernels! kernels)
  (define compare (make-order))
  (define by-rank
    (sort kernels (lambda (a b)
                    (< (compare (kernel-expression a) (kernel-expression b)) 0))))
  (for ([k (in-list by-rank)] [rank (in-naturals)]) (set-kernel-rank! k rank))
  (define by-index (sort by-rank > #:key term-priority))
  (for ([k (in-list by-index)] [index (in-naturals)]) (set-kernel-index! k index))
  (list->vector by-index))

;; Symbols first, then by descending order of differentiation.
(define (term-priority k)
  (define e (kernel-expression k))
  (if (symbol? e) +inf.0 (derivative-order e)))
