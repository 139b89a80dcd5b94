#lang racket/base
;; Comparison, generic.
;;
;; Numbers compare as numbers.  Equality of expressions is structural, which is
;; equality at a generic point; an order between values that are not constant
;; does not exist, and asking for it is an error that names the value.

(require "kind.rkt" "structure.rkt" "arithmetic.rkt" "describe.rkt"
         "../algebra/expression.rkt")

(provide g:= g:< g:> g:<= g:>= g:zero? g:one? g:positive? g:negative?
         g:max g:min g:add1 g:sub1)

;; What comparisons look at: a dual number is compared by its value.
(define (comparand x)
  (define look (and (has-kind? x) (kind-comparand (kind-of x))))
  (if look (comparand (look x)) x))

;; ---------------------------------------------------------------------------
;; Equality

(define (equal-values? a b)
  (cond [(and (number? a) (number? b)) (= a b)]
        [else (equal-comparands? (comparand a) (comparand b))]))

(define (equal-comparands? a b)
  (cond [(and (number? a) (number? b)) (= a b)]
        [(and (expression? a) (expression? b)) (expression=? a b)]
        [(and (tuple? a) (tuple? b))
         (define s (adopt a))
         (define t (adopt b))
         (and (compatible? s t)
              (for/and ([x (in-vector (structure-elements s))]
                        [y (in-vector (structure-elements t))])
                (equal-values? x y)))]
        [else (equal? a b)]))

(define g:=
  (case-lambda
    [(a b) (equal-values? a b)]
    [(a) #t]
    [(a b . more) (and (equal-values? a b) (apply g:= b more))]))

(define (g:zero? x)
  (cond [(number? x) (zero? x)]
        [(symbolic? x) #f]
        [(tuple? x) (for/and ([e (in-vector (structure-elements (adopt x)))]) (g:zero? e))]
        [(has-kind? x) ((kind-zero? (kind-of x)) x)]
        [else #f]))

(define (g:one? x)
  (define c (comparand x))
  (and (number? c) (= c 1)))

;; ---------------------------------------------------------------------------
;; Order

(define-syntax-rule (define-order id name compare)
  (define id
    (let* ([two (lambda (a b)
                  (if (and (real? a) (real? b))
                      (compare a b)
                      (compare (real-comparand 'name a) (real-comparand 'name b))))]
           [name (case-lambda
                   [(a b) (two a b)]
                   [(a) (and (real-comparand 'name a) #t)]
                   [(a b . more) (and (two a b) (apply id b more))])])
      name)))

(define-order g:< < <)
(define-order g:> > >)
(define-order g:<= <= <=)
(define-order g:>= >= >=)

(define (real-comparand who x)
  (define c (comparand x))
  (if (real? c) c (raise-no-order who c)))

(define (raise-no-order who x)
  (raise-arguments-error
   who
   (if (symbolic? x)
       "an expression that is not a number has no order; give its symbols values first"
       "expected real numbers")
   "value" x))

(define (g:positive? x)
  (if (real? x) (positive? x) (positive? (real-comparand 'positive? x))))
(define (g:negative? x)
  (if (real? x) (negative? x) (negative? (real-comparand 'negative? x))))

(define g:max
  (let ([max (case-lambda
               [(a b) (if (and (real? a) (real? b)) (max a b) (if (g:< a b) b a))]
               [(a) a]
               [(a b . more) (apply g:max (g:max a b) more)])])
    max))
(define g:min
  (let ([min (case-lambda
               [(a b) (if (and (real? a) (real? b)) (min a b) (if (g:< b a) b a))]
               [(a) a]
               [(a b . more) (apply g:min (g:min a b) more)])])
    min))

(define (g:add1 x) (g:+ x 1))
(define (g:sub1 x) (g:- x 1))
