#lang racket/base
;; Forms: ways of writing a value, with the size each would have.
;;
;; Presentation compares forms by size before anything is built.  The size is
;; the number of symbols, numbers and operators one reads; a number that is not
;; written (1, or the sign of a difference) does not count.

(require "term.rkt"
         "../expression/exact-numbers.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/size.rkt"
         "../kernel/exponentials.rkt" "../kernel/kernel.rkt")

(provide (struct-out form) form-expression
         term-form sum-form product-form product-expression
         power-size smaller-form? smaller-form shorter-form)

;; sign : ±1; build : ±1 -> expression, given the sign to show
(struct form (size sign build) #:authentic)

(define (form-expression f) ((form-build f) (form-sign f)))

;; The second only if it saves a sixth: people recognise sums by their terms.
(define (smaller-form usual other) (if (smaller-form? usual other) other usual))

(define (smaller-form? usual other)
  (<= (* 6 (form-size other)) (* 5 (form-size usual))))

;; The second only if it is shorter at all.
(define (shorter-form usual other)
  (if (< (form-size other) (form-size usual)) other usual))

;; ---------------------------------------------------------------------------
;; Products

(define (term-form t inexact?)
  (product-form (term-coefficient t) (term-powers t) '() '() inexact?))

;; c · powers · sums / divisors, where sums are forms and divisors are (form .
;; exponent).  A denominator of c is written below when there is a sum above.
(define (product-form c powers sums divisors inexact?)
  (define-values (exponential others) (combine-exponentials powers))
  (define whole (absorb-into-roots others))
  (define above (by-rank (positive-powers whole)))
  (define below (by-rank (negative-powers whole)))
  (define extra
    (if exponential
        (list (form (expression-size exponential) 1 (lambda (sign) exponential)))
        '()))
  (define quotient? (or (pair? below) (pair? divisors)))
  (define sum? (or (pair? sums) (ormap sum-kernel? (map car above))))
  (define down? (and sum? quotient? (not inexact?)))
  (define top (if down? (numerator (abs c)) (abs c)))
  (define bottom (if down? (denominator c) 1))
  (define lower (map divisor-form divisors))
  (define (build sign)
    (define n (factors-expression (present-number (* sign top) inexact?) above sums extra))
    (if quotient?
        (make-node op:/ (list n (factors-expression bottom below '() lower)))
        n))
  (form (+ (factors-size top above sums extra)
           (if quotient? (+ 1 (factors-size bottom below '() lower)) 0)
           (if (negative? c) 1 0))
        (if (negative? c) -1 1)
        build))

;; The numerator, or the denominator.  sums, extra : forms; these come last
(define (factors-expression c powers sums extra)
  (product-expression c (append (insert-sums (map form-expression sums)
                                             (powers->expressions powers))
                                (map form-expression extra))))

(define (factors-size c powers sums extra)
  (define size (+ (powers-size powers) (sizes sums) (sizes extra)))
  (define count (+ (length powers) (length sums) (length extra)))
  (cond [(eqv? count 0) 1]
        [(eqv? c 1) (+ size (if (eqv? count 1) 0 1))]
        [else (+ size 2)]))

(define (divisor-form d)
  (form (+ (form-size (car d)) (if (eqv? 1 (cdr d)) 0 2))
        1
        (lambda (sign) (expt-expression (form-expression (car d)) (cdr d)))))

;; The number c times the factors, the first of which may be numbers, too.
(define (product-expression c factors)
  (cond [(null? factors) c]
        [(number? (car factors)) (product-expression (* c (car factors)) (cdr factors))]
        [(not (eqv? c 1)) (make-node op:* (cons c factors))]
        [(null? (cdr factors)) (car factors)]
        [else (make-node op:* factors)]))

(define (powers->expressions powers)
  (for/list ([p (in-list powers)]) (power-expression (car p) (cdr p))))

;; kernel^n, n positive; powers of a root are powers of its radicand.
(define (power-expression k n)
  (define r (kernel-relation k))
  (cond [(eqv? n 1) (kernel-expression k)]
        [(and (root? r) (not (number? (kernel-expression k))))
         (expt-expression (root-radicand r) (/ n (root-degree r)))]
        [else (expt-expression (kernel-expression k) n)]))

(define (expt-expression base exponent)
  (cond [(eqv? exponent 1) base]
        [(eqv? exponent 1/2) (make-node op:sqrt (list base))]
        [else (make-node op:expt (list base exponent))]))

;; Where both a kernel x and its root stand, powers of x count as powers of the
;; root: x √x is x^(3/2).
(define (absorb-into-roots powers)
  (for/fold ([powers powers]) ([p (in-list powers)])
    (define r (kernel-relation (car p)))
    (define x
      (and (root? r)
           (for/first ([q (in-list powers)]
                       #:when (equal? (kernel-expression (car q)) (root-radicand r)))
             q)))
    (if x
        (cons (cons (car p) (+ (cdr p) (* (root-degree r) (cdr x))))
              (remq p (remq x powers)))
        powers)))

;; Sums stand after the symbols and before the other kernels.
(define (insert-sums sums factors)
  (if (and (pair? sums) (pair? factors) (symbol-power? (car factors)))
      (cons (car factors) (insert-sums sums (cdr factors)))
      (append sums factors)))

(define (symbol-power? e)
  (or (symbol? e)
      (and (headed? e op:expt) (symbol? (car (node-args e))))))

;; ---------------------------------------------------------------------------
;; Sums

;; At least one summand, in order.  One positive and one negative make a
;; difference; a sum does not begin with a negative term if it can be helped.
(define (sum-form forms)
  (cond [(null? forms) zero-form]
        [(null? (cdr forms)) (car forms)]
        [else
         (define difference (difference? forms))
         (form (+ (if difference 0 1) (sizes forms))
               1
               (lambda (sign) (signed sign (if difference (subtract forms) (add forms)))))]))

;; Nothing is left where decimals of one value, written differently, cancel.
(define zero-form (form 1 1 (lambda (sign) 0)))

(define (signed sign e) (if (eqv? sign 1) e (e:negate e)))

(define (difference? forms)
  (and (null? (cddr forms))
       (not (eqv? (form-sign (car forms)) (form-sign (cadr forms))))))

(define (subtract forms)
  (define ordered (if (eqv? 1 (form-sign (car forms))) forms (reverse forms)))
  (make-node op:- (for/list ([f (in-list ordered)]) ((form-build f) 1))))

(define (add forms)
  (define first-positive (findf (lambda (f) (eqv? 1 (form-sign f))) forms))
  (define ordered
    (if first-positive (cons first-positive (remq first-positive forms)) forms))
  (make-node op:+ (map form-expression ordered)))

;; ---------------------------------------------------------------------------
;; Sizes

(define (sizes forms) (apply + (map form-size forms)))

(define (powers-size powers)
  (for/sum ([p (in-list powers)]) (power-size (car p) (cdr p))))

(define (power-size k n)
  (define r (kernel-relation k))
  (define unit? (eqv? 1 (if (and (root? r) (> n 1)) (/ n (root-degree r)) (abs n))))
  (+ (kernel-size k) (if unit? 0 2)))
