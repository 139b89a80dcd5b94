#lang racket/base
;; The rule of signs.
;;
;; The sign of a real number is known as a set: those of -, 0 and + that
;; it may have, three bits.  A product may have the products of its factors'
;; signs, a sum the sums of its terms' signs, where - and + may sum to any.
;; Nothing known is the whole set; the empty set is a contradiction.

(provide any-sign negative nonpositive zero positive nonnegative nonzero
         number-signs signs-within? signs-decided?
         signs-product signs-sum signs-negate signs-power
         factor-signs term-signs)

(define any-sign #b111)
(define negative #b001)
(define nonpositive #b011)
(define zero #b010)
(define positive #b100)
(define nonnegative #b110)
(define nonzero #b101)

(define (sign-set x) (cond [(< x 0) negative] [(> x 0) positive] [else zero]))

;; Of a number that is not real nothing is known.
(define (number-signs x) (if (and (real? x) (= x x)) (sign-set x) any-sign))

(define (signs-within? a b) (eqv? a (bitwise-and a b)))

;; Is it known to be not negative, or not positive?
(define (signs-decided? s) (or (signs-within? s nonnegative) (signs-within? s nonpositive)))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (members s)
  (filter (lambda (x) (signs-within? (sign-set x) s)) '(-1 0 1)))

(define (combine f a b)
  (for*/fold ([s 0]) ([x (in-list (members a))] [y (in-list (members b))])
    (bitwise-ior s (f x y))))

(define (signs-product a b) (combine (lambda (x y) (sign-set (* x y))) a b))

(define (signs-sum a b)
  (combine (lambda (x y) (if (eqv? (* x y) -1) any-sign (sign-set (+ x y)))) a b))

(define (signs-negate a) (signs-product negative a))

;; An integer power, where it is defined.
(define (signs-power a n)
  (for/fold ([s 0]) ([x (in-list (members a))] #:unless (and (eqv? x 0) (< n 0)))
    (bitwise-ior s (sign-set (expt x (abs n))))))

;; ---------------------------------------------------------------------------
;; Signs of a value's parts

;; The signs x may have if xⁿ · y has one of `signs` and y one of `others`.
(define (factor-signs signs n others)
  (possible signs (lambda (x) (signs-product (signs-power x n) others))))

;; The signs x may have if x + y has one of `signs` and y one of `others`.
(define (term-signs signs others)
  (possible signs (lambda (x) (signs-sum x others))))

(define (possible signs value)
  (for/fold ([s 0]) ([x (in-list (list negative zero positive))]
                     #:unless (eqv? 0 (bitwise-and signs (value x))))
    (bitwise-ior s x)))
