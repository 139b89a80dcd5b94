#lang racket/base
;; Terms: a number times powers of kernels, and how sums of them are written.
;;
;; The book's habits.  In a product: the number, symbols by the alphabet, other
;; kernels with the highest derivatives last.  In a sum: terms in the order of
;; their kernels, higher powers first, so that a residual is grouped by its
;; symbols and then by its highest derivatives; a number comes first.  A sum of
;; one positive and one negative term is a difference; a sum does not begin
;; with a negative term if it can be helped.

(require "operation.rkt" "expression.rkt" "kernel.rkt" "exact.rkt")

(provide (struct-out term) term-sort
         term-split product-expression sum-expression terms->expression
         power-expression
         term-size terms-size expression-size)

;; powers : ((kernel . exponent) ...), by ascending place, exponents not 0
(struct term (coefficient powers) #:authentic)

;; ---------------------------------------------------------------------------
;; Order

(define (term-sort terms) (sort terms term<?))

(define (term<? a b) (powers<? (term-powers a) (term-powers b)))

(define (powers<? as bs)
  (cond [(null? as) #f]
        [(null? bs) #t]
        [else
         (define i (kernel-place (caar as)))
         (define j (kernel-place (caar bs)))
         (cond [(< i j) #t]
               [(> i j) #f]
               [(eqv? (cdar as) (cdar bs)) (powers<? (cdr as) (cdr bs))]
               [else (> (cdar as) (cdar bs))])]))

;; ---------------------------------------------------------------------------
;; Products

;; -> the factors above and below the line, each in the order of a product.
(define (term-split t)
  (define ordered (sort (term-powers t) < #:key (lambda (p) (kernel-rank (car p)))))
  (values (for/list ([p (in-list ordered)] #:when (positive? (cdr p)))
            (power-expression (car p) (cdr p)))
          (for/list ([p (in-list ordered)] #:when (negative? (cdr p)))
            (power-expression (car p) (- (cdr p))))))

;; kernel^n, n positive; powers of a root are powers of its radicand.
(define (power-expression k n)
  (define r (kernel-relation k))
  (cond [(eqv? n 1) (kernel-expression k)]
        [(and (root? r) (not (number? (kernel-expression k))))
         (expt-expression (root-radicand r) (/ n (root-degree r)))]
        [else (expt-expression (kernel-expression k) n)]))

(define (expt-expression base exponent)
  (cond [(eqv? exponent 1) base]
        [else (make-node op:expt (list base exponent))]))

;; A number times expressions.
(define (product-expression c factors)
  (cond [(null? factors) c]
        [(not (eqv? c 1)) (make-node op:* (cons c factors))]
        [(null? (cdr factors)) (car factors)]
        [else (make-node op:* factors)]))

(define (quotient-expression c above below)
  (define numerator (product-expression c above))
  (if (null? below)
      numerator
      (make-node op:/ (list numerator (product-expression 1 below)))))

;; ---------------------------------------------------------------------------
;; Sums

;; items : ((number . make-expression) ...), where make-expression takes the
;; number to show: terms with their signs apart.
(define (sum-expression items)
  (define (signed item) ((cdr item) (car item)))
  (define (unsigned item) ((cdr item) (abs (car item))))
  (cond [(null? items) 0]
        [(null? (cdr items)) (signed (car items))]
        [(difference? items)
         (define-values (positive negative)
           (if (negative? (caar items))
               (values (cadr items) (car items))
               (values (car items) (cadr items))))
         (make-node op:- (list (signed positive) (unsigned negative)))]
        [else (make-node op:+ (map signed (positive-first items)))]))

(define (difference? items)
  (and (null? (cddr items))
       (not (eq? (negative? (caar items)) (negative? (caadr items))))))

(define (positive-first items)
  (define first-positive (for/first ([i (in-list items)] #:unless (negative? (car i))) i))
  (if (and first-positive (negative? (caar items)))
      (cons first-positive (remq first-positive items))
      items))

;; Sorted terms as a sum; a positive constant term comes first.
(define (terms->expression terms inexact?)
  (sum-expression (for/list ([t (in-list (constant-first terms))]) (term->item t inexact?))))

(define (constant-first terms)
  (define constant (for/first ([t (in-list terms)] #:when (null? (term-powers t))) t))
  (if (and constant (positive? (term-coefficient constant)))
      (cons constant (remq constant terms))
      terms))

(define (term->item t inexact?)
  (define-values (above below) (term-split t))
  (cons (term-coefficient t)
        (lambda (c) (quotient-expression (present-number c inexact?) above below))))

;; ---------------------------------------------------------------------------
;; Size: the symbols and numbers one reads, each head counted as one

(define (expression-size e)
  (node-fold e
             (lambda (leaf) 1)
             (lambda (n sizes) (apply + (head-size (node-head n)) sizes))))

(define (head-size h)
  (if (and (literal-head? h) (pair? (literal-head-index h))) 2 1))

;; As written in a sum: products and quotients count for one.
(define (term-size t kernel-size)
  (define powers (term-powers t))
  (define c (term-coefficient t))
  (define unit? (eqv? c 1))
  (define factors
    (for/sum ([p (in-list powers)])
      (+ (kernel-size (car p)) (if (eqv? 1 (abs (cdr p))) 0 2))))
  (define below (for/or ([p (in-list powers)]) (negative? (cdr p))))
  (+ factors
     (if unit? 0 1)
     (if (and (pair? powers) (or (pair? (cdr powers)) (not unit?))) 1 0)
     (if below 1 0)))

(define (terms-size terms kernel-size)
  (for/fold ([size (if (or (null? terms) (null? (cdr terms))) 0 1)]) ([t (in-list terms)])
    (+ size (term-size t kernel-size))))
