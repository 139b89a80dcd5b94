#lang racket/base
;; Floating-point numbers of any precision, as values of the arithmetic.
;;
;; A bigfloat is one of math/bigfloat's in a struct that carries a kind.  The result
;; of an operation has as many bits as the more precise one of its arguments.
;; Racket's numbers enter at their exact value: exact ones are rounded to the
;; precision of the other argument, flonums, which have 53 bits, are not.  Beside
;; symbols a bigfloat stands for its own exact value, a fraction, so that nothing is
;; lost where a program is traced on them.

(require (prefix-in m: math/bigfloat)
         "../algebra/expression/expression.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/dispatch.rkt" "../generic/kind.rkt"
         "../generic/irrational.rkt" "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         "../numeric/bigfloat/bigfloat-arithmetic.rkt" "../numeric/bigfloat/bigfloat-systems.rkt"
         "../numeric/finite-number.rkt"
         "../numeric/linear-algebra/row-matrix.rkt")

(provide bigfloat bigfloat? bigfloat-precision bigfloat->exact
         ;; linear systems
         bigfloat-solutions
         ;; to and from those of math/bigfloat
         (rename-out [big wrap]) raw-bigfloat)

(define kind:bigfloat
  (make-kind #:rank rank:number
             #:describe (lambda (x) (format "a number of ~a bits" (bigfloat-precision x)))
             #:datum values
             #:unary operate-1
             #:binary operate-2
             #:comparand (lambda (x) (exact-value (big-value x)))))

(value-struct big (value)
  #:kind kind:bigfloat
  #:text numeral
  #:equal-by big-value)

;; As flonums are written, with a point or an exponent.
(define (numeral b)
  (define x (big-value b))
  (cond [(m:bfnan? x) "+nan.0"]
        [(m:bfinfinite? x) (if (m:bfnegative? x) "-inf.0" "+inf.0")]
        [else
         (define digits (m:bigfloat->string x))
         (if (regexp-match? #rx"[.e]" digits) digits (string-append digits ".0"))]))

;; ---------------------------------------------------------------------------
;; Making and asking

(define default-bits 128)

;; x : a real number, a numeral or a bigfloat
(define (bigfloat x [bits default-bits])
  (unless (and (exact-integer? bits) (<= 2 bits 1000000))
    (complain-of-argument 'bigfloat "a number of bits from 2 to 1000000" bits))
  (check-bigfloats 'bigfloat)
  (define value
    (with-bits bits
      (cond [(or (real? x) (irrational? x)) (raw-bigfloat x)]
            [(big? x) (m:bfcopy (big-value x))]
            [(m:bigfloat? x) (m:bfcopy x)]
            [(string? x) (m:string->bigfloat x)]
            [else #f])))
  (unless (m:bigfloat? value)
    (complain-of-argument 'bigfloat "a real number or the numeral of one, such as \"0.1\"" x))
  (big value))

(define (bigfloat? x) (big? x))

(define (bigfloat-precision x)
  (check 'bigfloat-precision x)
  (bits x))

(define (bits x) (m:bigfloat-precision (big-value x)))

;; A fraction; of infinities and NaN, the flonum.
(define (bigfloat->exact x)
  (check 'bigfloat->exact x)
  (exact-value (big-value x)))

(define (check who x)
  (check-argument who big? x "a number of higher precision, such as (bigfloat 2 100)"))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (operate-1 op x)
  (define name (generic-op-name op))
  (define f (operation-on-bigfloats name 1))
  (cond [(eq? name 'exact->inexact) (m:bigfloat->flonum (big-value x))]
        [(eq? name 'inexact->exact) (bigfloat->exact x)]
        [f (big (with-bits (bits x) (f (big-value x))))]
        [else (raise-inapplicable op x)]))

(define (operate-2 op a b)
  (define f (operation-on-bigfloats (generic-op-name op) 2))
  (cond [(or (not f) (not-real? a) (not-real? b)) (raise-inapplicable op a b)]
        [(symbolic? a) ((generic-op-procedure op) a (bigfloat->exact b))]
        [(symbolic? b) ((generic-op-procedure op) (bigfloat->exact a) b)]
        [(trivially (generic-op-name op) a b)]
        [else (in-common-precision f a b)]))

(define (in-common-precision f a b)
  (define most
    (cond [(not (big? a)) (bits b)]
          [(not (big? b)) (bits a)]
          [else (max (bits a) (bits b))]))
  (big (with-bits most (f (raw-bigfloat a) (raw-bigfloat b)))))

;; A number of Racket's or ours as one of math/bigfloat.
(define (raw-bigfloat x)
  (cond [(big? x) (big-value x)]
        [(irrational? x)
         (irrational-fold x bigfloat-root (on-bigfloats m:bf+) (on-bigfloats m:bf*))]
        [else (real->bigfloat x)]))

(define (bigfloat-root n exponent) (m:bfexpt (m:bf n) (real->bigfloat exponent)))

(define ((on-bigfloats f) x y)
  (define (big x) (if (real? x) (real->bigfloat x) x))
  (f (big x) (big y)))

;; The result where an argument is exact 0 or 1, as with Racket's own numbers; or #f.
(define (trivially name a b)
  (case name
    [(+) (cond [(eqv? a 0) b] [(eqv? b 0) a] [else #f])]
    [(-) (and (eqv? b 0) a)]
    [(*) (cond [(or (eqv? a 0) (eqv? b 0)) 0] [(eqv? a 1) b] [(eqv? b 1) a] [else #f])]
    [(/) (cond [(eqv? b 0) (raise-zero-divisor a)] [(eqv? a 0) 0] [(eqv? b 1) a] [else #f])]
    [(expt) (cond [(or (eqv? b 0) (eqv? a 1)) 1] [(eqv? b 1) a] [else #f])]
    [else #f]))

(define (raise-zero-divisor a)
  (raise-division-by-zero '/ (format "division by zero\n  in: (/ ~a 0)" (value->text a))))

;; ---------------------------------------------------------------------------
;; Linear systems

;; The rows of x with A x = right, or 'singular; at least one entry is a bigfloat.
(define (bigfloat-solutions A right)
  (define most
    (for*/fold ([most 2]) ([rows (list A right)] [row (in-vector rows)] [x (in-vector row)])
      (if (big? x) (max most (bits x)) most)))
  (with-bits most
    (define x (solutions (rows-map raw-bigfloat A) (rows-map raw-bigfloat right)))
    (if (eq? x 'singular) x (rows-map big x))))
