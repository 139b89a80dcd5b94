#lang racket/base
;; Irrational numbers that are kept exact: sums of roots of rational numbers, such as √2 and
;; (1 + √5)/2.
;;
;; The square root of an exact number that is no square is one, and results of + - * / and powers
;; with rational exponents of them and exact numbers are exact, as long as they are short.  A
;; longer one, or no sum of roots, as √(2 + √2), is a decimal, as is whatever has a decimal or
;; any other function to do with one.  Beside symbols it is the expression that it prints as.

(require "kind.rkt" "on-demand.rkt" "value-struct.rkt"
         "../algebra/expression/constant-value.rkt" "../algebra/expression/expression.rkt")

;; Most programs hold no such number.
(require-on-demand
 ["../algebra/radical/radical-expression.rkt" radicals->expression expression->radicals]
 ["../algebra/radical/radical-power.rkt" radicals-expt]
 ["../algebra/radical/radical-sum.rkt"
  rational->radicals radicals->rational radicals-add radicals-subtract radicals-scale
  radicals-multiply radicals-invert radicals->flonum radicals-small? radicals-fold])

(provide irrational? exact-real? irrational-power irrational-fold
         irrational-as-decimal irrational-as-expression irrational->expression
         other-number->expression constant->number)

(define kind:irrational
  (make-kind #:rank rank:number
             #:describe (lambda (x) "an exact number")
             #:datum (lambda (x) (expression->datum (irrational->expression x)))
             #:unary operate-1
             #:binary operate-2
             #:comparand decimal))

;; radicals : a sum of roots, irrational;  cached : its decimal, or #f where nobody asked yet
(value-struct irrational (radicals [cached #:mutable])
  #:kind kind:irrational
  #:equal-by irrational-radicals)

(define (decimal x)
  (or (irrational-cached x)
      (let ([value (radicals->flonum (irrational-radicals x))])
        (set-irrational-cached! x value)
        value)))

;; -> a rational number, one of ours or, of long sums, the decimal
(define (radicals->number s)
  (define x (radicals->rational s))
  (cond [x x]
        [(radicals-small? s) (irrational s #f)]
        [else (radicals->flonum s)]))

;; x : an exact number, Racket's or ours
(define (number->radicals x) (if (irrational? x) (irrational-radicals x) (rational->radicals x)))

;; ---------------------------------------------------------------------------
;; As expressions and decimals

(define (irrational->expression x) (radicals->expression (irrational-radicals x)))

;; One of ours in another form; anything else as it is.
(define (irrational-as-expression x) (if (irrational? x) (irrational->expression x) x))
(define (irrational-as-decimal x) (if (irrational? x) (decimal x) x))

;; The expression that a number of another type than Racket's stands for beside symbols.
(define (other-number->expression x) (if (irrational? x) (irrational->expression x) (comparand x)))

;; The number that an expression without symbols and π stands for, if it is a sum of roots or
;; holds a decimal; else the expression.
(define (constant->number e)
  (cond [(not (and (node? e) (all-leaves? number? e))) e]
        [(expression->radicals e) => radicals->number]
        [(some-leaf? flonum? e) (or (constant-value e) e)]
        [else e]))

;; The sum with its roots taken by (root n exponent), combined by add and multiply.
(define (irrational-fold x root add multiply)
  (radicals-fold (irrational-radicals x) root add multiply))

;; ---------------------------------------------------------------------------
;; Arithmetic

;; x : an exact number;  r : rational, not whole where x is rational
;; -> x^r, exact where it is a sum of roots and real
(define (irrational-power x r)
  (define power (and (not (eqv? x 0)) (radicals-expt (number->radicals x) r)))
  (if power (radicals->number power) (expt (irrational-as-decimal x) r)))

(define (operate-1 op x)
  (case (generic-op-name op)
    [(sqrt) (irrational-power x 1/2)]
    [(abs) (if (negative? (decimal x)) (opposite x) x)]
    [(sgn) (if (negative? (decimal x)) -1 1)]
    [(inexact->exact) x]
    [(exact->inexact) (decimal x)]
    [else ((generic-op-procedure op) (decimal x))]))

(define (opposite x) (radicals->number (radicals-scale -1 (irrational-radicals x))))

(define (operate-2 op a b)
  (cond [(or (symbolic? a) (symbolic? b))
         ((generic-op-procedure op) (irrational-as-expression a) (irrational-as-expression b))]
        [(and (exact-real? a) (exact-real? b)) (operate-exactly op a b)]
        [(foreign a b) => (lambda (x) ((kind-binary (kind-of x)) op a b))]
        [else ((generic-op-procedure op) (irrational-as-decimal a) (irrational-as-decimal b))]))

;; Is x an exact real number, Racket's or ours?
(define (exact-real? x) (or (irrational? x) (and (rational? x) (exact? x))))

;; The one that is a number of a third type, or #f.
(define (foreign a b)
  (for/first ([x (list a b)] #:unless (or (number? x) (irrational? x))) x))

(define (operate-exactly op a b)
  (define (by combine) (radicals->number (combine (number->radicals a) (number->radicals b))))
  (case (generic-op-name op)
    [(+) (by radicals-add)]
    [(-) (by radicals-subtract)]
    [(*) (by radicals-multiply)]
    [(/) (quotient-of a b)]
    [(expt) (power-of a b)]
    [else ((generic-op-procedure op) (irrational-as-decimal a) (irrational-as-decimal b))]))

(define (quotient-of a b)
  (define inverse (and (not (eqv? b 0)) (radicals-invert (number->radicals b))))
  (cond [inverse (radicals->number (radicals-multiply (number->radicals a) inverse))]
        [(eqv? b 0) (e:/ (irrational-as-expression a) b)]
        [else (/ (irrational-as-decimal a) (irrational-as-decimal b))]))

(define (power-of a b)
  (if (irrational? b) (expt (irrational-as-decimal a) (decimal b)) (irrational-power a b)))
