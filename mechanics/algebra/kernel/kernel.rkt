#lang racket/base
;; Kernels: the variables of the polynomials an expression is written in.
;;
;; A kernel is a symbol, a literal function applied, the sine or the cosine of
;; an angle, a root ...: anything the arithmetic takes as a whole.  Some kernels
;; satisfy a relation:
;;
;;     sin²θ = 1 - cos²θ,   sinh²u = cosh²u - 1,   rᵠ = u for r = u^(1/q),   |u|² = u².
;;
;; When all kernels of an expression are known each gets an `index` as a
;; variable, a `rank`, which orders the factors of a product, and a `place`,
;; which orders the terms of a sum.  Symbols come first in both, by the
;; alphabet; after them a sum shows the highest derivatives first, a product
;; last.  Presentation may add kernels, which are ranked between the others.

(require "../expression/expression.rkt" "../expression/operation.rkt" "../expression/order.rkt"
         "../expression/size.rkt" "../expression/substitute.rkt")

(provide (struct-out kernel) make-kernel sum-kernel? circular-kernel? hyperbolic-kernel?
         exponential-kernel?
         kernel-expressions place-kernels! insert-kernel!
         (struct-out circle) (struct-out angle) (struct-out root)
         (struct-out modulus) (struct-out exponential)
         sum-of-terms signed-operands function-value shorter-expression?)

;; relation : #f, or the circle, root, modulus or exponential this kernel is of
;; size : of the expression, as written
(struct kernel (expression relation size
                           [index #:mutable] [rank #:mutable] [place #:mutable])
  #:authentic)

(define (make-kernel expression relation)
  (kernel expression relation (expression-size expression) #f #f #f))

;; Is it a sum taken as a whole?
(define (sum-kernel? k) (sum? (kernel-expression k)))

;; Is it a sine or a cosine?
(define (circular-kernel? k) (either-headed? k op:sin op:cos))
(define (hyperbolic-kernel? k) (either-headed? k op:sinh op:cosh))

(define (either-headed? k a b)
  (define e (kernel-expression k))
  (or (headed? e a) (headed? e b)))

(define (exponential-kernel? k) (exponential? (kernel-relation k)))

;; A table of the kernels' expressions, each with #t.
(define (kernel-expressions kernels)
  (for/hash ([k kernels]) (values (kernel-expression k) #t)))

;; The sine and the cosine of a basic angle; hyperbolic ones if sign is -1.
(struct circle (expression sign [sine #:mutable] [cosine #:mutable])
  #:authentic)

;; An angle occurring under a sine or cosine: a linear form over atoms, and how
;; many times each basic angle it is, ((circle . integer) ...).  An exponent is an
;; angle too; there it is ((kernel . integer) ...), powers of basic exponentials.
(struct angle (form [multiples #:mutable])
  #:authentic)

;; The root of this degree of a radicand.  Until all is met more becomes known:
;; the degree, and candidates ((radicand . scale) ...) for a more readable
;; radicand, scale^degree times the one it began with.
(struct root ([radicand #:mutable] [degree #:mutable] [scale #:mutable]
              [candidates #:mutable] [kernel #:mutable])
  #:authentic)

;; The absolute value of an expression.
(struct modulus (argument) #:authentic)

;; e^exponent, and the simplifier of exponents.
(struct exponential (exponent simplifier) #:authentic)

;; ---------------------------------------------------------------------------
;; Expressions

;; The sum of ((number . expression) ...)
(define (sum-of-terms terms)
  (rebuild op:+ (for/list ([t (in-list terms)]) (e:* (car t) (cdr t)))))

;; ((operand . ±1) ...) of an operation within the same or its inverse: of nested sums and
;; differences, or products and quotients.
(define (signed-operands e op inverse [sign 1])
  (cond [(headed? e op)
         (for*/list ([a (in-list (node-args e))]
                     [o (in-list (signed-operands a op inverse sign))])
           o)]
        [(headed? e inverse)
         (append (signed-operands (car (node-args e)) op inverse sign)
                 (signed-operands (cadr (node-args e)) op inverse (- sign)))]
        [else (list (cons e sign))]))

;; The sine, cosine or tangent, circular or hyperbolic, by sine and cosine.
(define (function-value head sine cosine)
  (cond [(memq head (list op:sin op:sinh)) sine]
        [(memq head (list op:cos op:cosh)) cosine]
        [else (e:/ sine cosine)]))

;; Is a shorter than b, or as long and before it in the order of expressions?
(define (shorter-expression? a b)
  (define d (- (expression-size a) (expression-size b)))
  (or (< d 0) (and (eqv? d 0) (expression<? a b))))

;; ---------------------------------------------------------------------------
;; Places

;; Gives every kernel its index, rank and place; -> the kernels as a vector.
(define (place-kernels! kernels)
  (define by-rank (sort kernels (kernel-before? (make-order))))
  (for ([k (in-list by-rank)] [rank (in-naturals)]) (set-rank! k rank))
  (define by-place (sort by-rank < #:key kernel-place))
  (for ([k (in-list by-place)] [index (in-naturals)]) (set-kernel-index! k index))
  (list->vector by-place))

(define ((kernel-before? compare) a b)
  (< (compare (kernel-expression a) (kernel-expression b)) 0))

;; Symbols first, then by descending order of differentiation.
(define (set-rank! k rank)
  (define e (kernel-expression k))
  (define class (if (symbol? e) 0 (- 1000 (derivative-order e))))
  (set-kernel-rank! k rank)
  (set-kernel-place! k (+ rank (* 1000000 class))))

;; Ranks a new kernel among others, a list by rank; -> the list with it.
(define (insert-kernel! k ranked)
  (define before? (kernel-before? (make-order)))
  (define (between a b)
    (cond [(and a b) (/ (+ (kernel-rank a) (kernel-rank b)) 2)]
          [a (+ (kernel-rank a) 1)]
          [b (- (kernel-rank b) 1)]
          [else 0]))
  (let loop ([previous #f] [rest ranked])
    (cond [(or (null? rest) (before? k (car rest)))
           (set-rank! k (between previous (and (pair? rest) (car rest))))
           (cons k rest)]
          [else (cons (car rest) (loop (car rest) (cdr rest)))])))
