#lang racket/base
;; Series: endless sums whose terms are any values of the arithmetic.
;;
;; A *series* a₀ + a₁ + a₂ + ⋯ keeps its terms apart by their order: the product
;; collects the products of terms by the sum of their orders.  Terms that are
;; functions are applied, each of them, when the series is.  A *power series* is
;; given by coefficients, a₀ + a₁x + a₂x² + ⋯, and is a function of x: applied to
;; one, it gives the series of its terms.
;;
;; Terms are computed when asked for, and remembered.

(require "coefficients.rkt" "series-operation.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt" "../../generic/function.rkt" "../../generic/kind.rkt"
         "../../generic/on-demand.rkt" "../../generic/scalar.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/up-down.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt")

(provide series:ref check-series
         series? power-series? series-of power-series-of power-series-with-terms like-series
         series-coefficients series-term series-length finite-series? map-series
         coefficients-of collapse compared-terms powers-of)

(require-on-demand ["series-notation.rkt" series-notation])

;; ---------------------------------------------------------------------------
;; Data

(define kind:series
  (make-kind #:rank rank:series
             #:describe (lambda (s) (if (power-series? s) "a power series" "a series"))
             #:datum series-datum
             #:notation notation-of-series
             #:map (lambda (f s) (map-series (lambda (x) (map-leaves f x)) s))
             #:component series:ref
             #:unary series-unary
             #:binary series-binary
             #:zero? (lambda (s)
                       (and (finite-series? s)
                            (andmap g:zero? (all-terms s))))
             #:same? same-series?
             #:arity (lambda (s) (if (power-series? s) 2 -1))))

;; terms-at : of a power series, x -> the coefficients of the series of its terms at
;; x; else #f
(value-struct series (coefficients terms-at)
  #:kind kind:series
  #:equality (lambda (a b recur)
               (or (eq? a b)
                   (and (eq? (power-series? a) (power-series? b))
                        (finite-series? a) (finite-series? b)
                        (recur (all-terms a) (all-terms b)))))
             (lambda (s recur) (if (finite-series? s) (recur (all-terms s)) 1))
  #:property prop:procedure (lambda (s . args) (apply-series s args)))

(define (series-of coefficients) (series coefficients #f))
(define (power-series-of coefficients)
  (series coefficients (lambda (x) (terms-at coefficients x))))
(define (power-series? x) (and (series? x) (series-terms-at x) #t))

;; A power series that finds its terms at x otherwise than by powers of x.
(define (power-series-with-terms coefficients terms-at) (series coefficients terms-at))

;; A series of the same sort with other terms.
(define (like-series s coefficients)
  (if (power-series? s) (power-series-of coefficients) (series-of coefficients)))

;; The term of order k; of a power series, the coefficient.
(define (series:ref s k)
  (check-series 'series:ref s)
  (check-argument 'series:ref exact-nonnegative-integer? k "the order of a term")
  (series-term s k))

(define (check-series who s)
  (unless (series? s)
    (complain-of-argument who "a series" s
                          (if (procedure? s)
                              "\n  a function whose values are series must be applied first"
                              ""))))

(define (series-term s k) (coefficient (series-coefficients s) k))
(define (series-length s) (coefficients-length (series-coefficients s)))
(define (finite-series? s) (coefficients-finite? (series-coefficients s)))

(define (first-terms s n) (for/list ([k (in-range n)]) (series-term s k)))
(define (all-terms s) (first-terms s (series-length s)))

;; f applied to each term, when it is asked for; f takes 0 to 0.
(define (map-series f s)
  (like-series s (make-coefficients (lambda (k) (f (series-term s k))) (series-length s))))

;; ---------------------------------------------------------------------------
;; Printing and comparing: of an endless series only the first terms

(define shown-terms 4)
(define compared-terms 8)

(define (series-datum s)
  (define n (if (finite-series? s) (series-length s) shown-terms))
  `(,(if (power-series? s) 'power-series 'series)
    ,@(map value->datum (first-terms s n))
    ,@(if (finite-series? s) '() '(...))))

;; The sum of the terms that are not 0; of a power series, the function of x.
(define (notation-of-series s see)
  (define n (if (finite-series? s) (series-length s) shown-terms))
  (series-notation (for/list ([x (in-list (first-terms s n))]) (if (eqv? x 0) #f (see x)))
                   (finite-series? s) (power-series? s)))

(define (same-series? same? a b)
  (define n (max (series-length a) (series-length b)))
  (cond [(eq? a b) #t]
        [(not (eq? (power-series? a) (power-series? b))) #f]
        [(not (for/and ([k (in-range (min n compared-terms))])
                (same? (series-term a k) (series-term b k))))
         #f]
        [(<= n compared-terms) #t]
        [(eqv? n +inf.0) (raise-undecidable a b)]
        [else (for/and ([k (in-range compared-terms n)])
                (same? (series-term a k) (series-term b k)))]))

(define (raise-undecidable a b)
  (complain '=
            (string-append
             "two endless series agree in their first ~a terms, which does not decide whether "
             "they are equal\n  first: ~a\n  second: ~a\n"
             "  compare as many terms as matter: (series:head s n)")
            compared-terms (value->text a) (value->text b)))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (series-unary op s)
  (define commuting
    (make-coefficients (lambda (k) (check-commutes op (series-term s k))) (series-length s)))
  (like-series s (operate-1 op commuting (lambda (c) (like-series s c)) coefficients-of)))

;; Elementary functions assume that terms commute: else exp (A + B) is not exp A exp B.
(define (check-commutes op x)
  (when (and (has-kind? x) (memv (kind-rank (kind-of x)) (list rank:matrix rank:operator)))
    (complain (generic-op-name op) "the terms of the series must commute with each other; one is ~a"
              (describe-with-value x)))
  x)

(define (series-binary op a b)
  (define like (if (series? a) a b))
  (when (and (series? a) (series? b) (not (eq? (power-series? a) (power-series? b))))
    (raise-mixed op a b))
  (or (reduced op a b)
      (like-series like
                   (operate-2 op (coefficients-of a) (coefficients-of b)
                              (lambda (c) (like-series like c)) coefficients-of))))

(define (coefficients-of x)
  (if (series? x) (series-coefficients x) (coefficients-from (list x))))

(define (raise-mixed op a b)
  (complain (generic-op-name op)
            (string-append
             "one is a series, the other a power series; apply the power series to its "
             "variable first\n  argument 1: ~a\n  argument 2: ~a")
            (describe-with-value a) (describe-with-value b)))

;; ---------------------------------------------------------------------------
;; Application

(define (apply-series s args)
  (cond [(power-series? s)
         (unless (= (length args) 1) (raise-one-variable s args))
         (if (series? (car args))
             (compose-series s (car args))
             (series-of ((series-terms-at s) (car args))))]
        [else (values-at s args)]))

(define (raise-one-variable s args)
  (complain-of-arity (value->text s) "a power series takes one argument, its variable; given ~a"
                     (length args)))

;; Terms that are functions are applied; scalars among them are constants, among
;; operators multiples of the identity.  Where the value of the term of order n is a
;; series, its terms count from order n on.
(define (values-at s args)
  (when (and (finite-series? s) (not (ormap applicable? (all-terms s))))
    (raise-no-function s))
  (define (value x)
    (if (and (scalar? x) (pair? args) (procedure? (car args)) (of-operators? s))
        (g:* x (car args))
        (term-value x args)))
  (collapse (map-series value s)))

(define (of-operators? s)
  (for/or ([x (in-list (first-terms s shown-terms))])
    (and (has-kind? x) (eqv? (kind-rank (kind-of x)) rank:operator))))

(define (applicable? x) (or (procedure? x) (tuple? x) (map-leaf-kind? x)))
(define (map-leaf-kind? x) (and (has-kind? x) (kind-map (kind-of x)) #t))

(define (term-value x args) (if (series? x) (apply x args) (value-at x args)))

(define (raise-no-function s)
  (complain 'application
            (string-append
             "a series applies those of its terms that are functions,"
             " but ~a has none\n"
             "  (power-series a ...) makes a function of coefficients")
            (value->text s)))

;; A series of series as one series: term m of the series at order n has order n + m.
(define (collapse s)
  (define (term n) (series-term s n))
  (define finite? (finite-series? s))
  (define length
    (if finite?
        (for/fold ([length 0]) ([n (in-range (series-length s))])
          (max length (+ n (if (series? (term n)) (series-length (term n)) 1))))
        +inf.0))
  (define last (if finite? (sub1 (series-length s)) +inf.0))
  (like-series
   s
   (make-coefficients
    (lambda (k)
      (for/fold ([sum 0]) ([n (in-range (add1 (min k last)))])
        (define x (term n))
        (cond [(series? x) (g:+ sum (series-term x (- k n)))]
              [(eqv? n k) (g:+ sum x)]
              [else sum])))
    length)))

;; aₙ xⁿ.  The derivative of order n by a tuple is contracted with it n times, from
;; the outermost index on.
(define (terms-at coefficients x)
  (make-coefficients
   (lambda (n)
     (define a (coefficient coefficients n))
     (cond [(eqv? n 0) a]
           [(tuple? x) (for/fold ([product a]) ([_ (in-range n)]) (g:* product x))]
           [else (g:* a (g:expt x n))]))
   (coefficients-length coefficients)))

;; ---------------------------------------------------------------------------
;; Composition

;; Σ aₙ tⁿ, which is well defined order by order when t has no term of order 0; any
;; t will do where the sum is finite (Horner's rule).
(define (compose-series s t)
  (cond [(finite-series? s)
         (for/fold ([sum 0]) ([n (in-range (sub1 (series-length s)) -1 -1)])
           (g:+ (series-term s n) (g:* sum t)))]
        [(eqv? (series-term t 0) 0) (like-series t (composition s t))]
        [else
         (complain 'application
                   (string-append "an endless power series can be applied to a series "
                                  "only if that begins with 0; given ~a")
                   (value->text t))]))

;; Coefficient k is Σ_{n≤k} aₙ (tⁿ)_k.
(define (composition s t)
  (define powers (powers-of t))
  (make-coefficients
   (lambda (k)
     (if (eqv? k 0)
         (series-term s 0)
         (g:for/sum ([n (in-range 1 (add1 k))])
           (g:* (series-term s n) (series-term (coefficient powers n) k)))))))

;; t, t², t³, …, remembered; from index 1 on
(define (powers-of t)
  (define powers
    (make-coefficients (lambda (n) (if (eqv? n 1) t (g:* (coefficient powers (sub1 n)) t)))))
  powers)
