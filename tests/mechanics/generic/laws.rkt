#lang racket/base
;; Generic arithmetic obeys the laws of rings and modules, on every kind of value
;; and on mixtures of kinds.

(require mechanics/generic/arithmetic
         mechanics/value/structure
         "../support/random.rkt" "../support/same.rkt"
         "../support/laws/derivation.rkt" "../support/laws/law.rkt" "../support/laws/module.rkt"
         "../support/laws/ring.rkt"
         "../support/random/element.rkt")

(define commutative-ring-laws (append ring-laws commutativity-laws power-laws))
(define field-laws (append commutative-ring-laws division-laws))

;; ---------------------------------------------------------------------------
;; Scalars

(check-laws "exact rationals" field-laws generic-ring random-rational equal? #:seed 101)
(check-laws "flonums" field-laws generic-ring random-flonum same? #:seed 102)
(check-laws "complex numbers" field-laws generic-ring random-complex same? #:seed 103)
(check-laws "symbols" field-laws generic-ring
            (lambda () (random-choice 'a 'b 'c)) same? #:seed 104)
(check-laws "expressions" field-laws generic-ring random-expression same? #:seed 105)
(check-laws "dual numbers" field-laws generic-ring random-dual same? #:seed 106)
(check-laws "dual numbers over expressions" field-laws generic-ring
            (lambda () (random-dual (lambda () (random-choice 'a 'b 2 'c)))) same? #:seed 107)

(define (random-scalar)
  ((random-choice random-rational random-flonum random-expression random-dual)))
(check-laws "scalars of all kinds at once" field-laws generic-ring random-scalar same? #:seed 108)

;; ---------------------------------------------------------------------------
;; Functions, matrices, operators

(check-laws "functions" field-laws generic-ring random-real-function same? #:seed 111)
(check-laws "functions and scalars" field-laws generic-ring
            (lambda () ((random-choice random-scalar random-real-function)))
            same? #:seed 112)
(check-laws "matrices of numbers" (append ring-laws power-laws division-laws) generic-ring
            random-matrix same? #:seed 113)
(check-laws "matrices of expressions" (append ring-laws power-laws division-laws) generic-ring
            (lambda () (random-matrix (lambda () (random-expression 1)))) same?
            #:seed 114 #:rounds 5)
(check-laws "matrices of numbers, of dual numbers, and numbers" (append ring-laws power-laws)
            generic-ring
            (lambda ()
              (case (random 3)
                [(0) (random-rational)]
                [(1) (random-matrix random-dual)]
                [(2) (random-matrix random-rational)]))
            same? #:seed 115)
(check-laws "operators" (append ring-laws power-laws) generic-ring
            random-operator same? #:seed 116 #:rounds 4)
(check-laws "operators and numbers" (append ring-laws power-laws) generic-ring
            (lambda () ((random-choice random-operator random-rational)))
            same? #:seed 117 #:rounds 4)

;; ---------------------------------------------------------------------------
;; Structures over scalars of every kind

(define (check-module title scalar element seed)
  (check-laws title module-laws generic-module (draw-with-scalars scalar element)
              same? #:seed seed))

(check-module "tuples of numbers" random-rational (random-up random-rational) 121)
(check-module "tuples of expressions" random-expression (random-up random-expression) 122)
(check-module "tuples of dual numbers" random-dual (random-up random-dual) 123)
(check-module "tuples of anything" random-scalar (random-up random-scalar) 124)
(check-module "nested tuples" random-rational (random-nested random-rational) 125)
(check-module "nested tuples of anything" random-scalar (random-nested random-scalar) 126)
(check-module "vectors" random-rational
              (lambda () (vector (random-rational) (random-rational))) 127)
(check-module "matrices" random-scalar (lambda () (random-matrix random-scalar)) 128)
(check-module "functions to tuples" random-rational
              (lambda ()
                (define f (random-function 2))
                (lambda (x) (up (f x) x)))
              129)

;; ---------------------------------------------------------------------------
;; Pairings: the dot product, and the contraction of a tuple with a flipped one

(define contraction
  (struct-copy module-operations generic-module
               [pair (lambda (x y) (g:* (flip x) y))]))

(for ([element (list (random-up random-rational) (random-up random-scalar)
                     (random-nested random-rational) (random-nested random-scalar))]
      [title
       '("tuples of numbers" "tuples of anything" "nested tuples" "nested tuples of anything")]
      [seed (in-naturals 131)])
  (define draw (draw-with-scalars random-scalar element))
  (check-laws (string-append title ", dot product")
              pairing-laws
              generic-module
              draw
              same?
              #:seed seed)
  (check-laws (string-append title ", contraction")
              pairing-laws
              contraction
              draw
              same?
              #:seed seed))
