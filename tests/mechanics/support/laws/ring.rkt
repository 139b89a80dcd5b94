#lang racket/base
;; The laws of rings, commutative rings and fields, for anything one can add and
;; multiply.

(require "law.rkt")

(provide (except-out (struct-out ring) ring?) ring-laws commutativity-laws division-laws power-laws)

(struct ring (zero one add subtract negate multiply divide square expt))

(define-laws ring-laws
  ([zero ring-zero] [one ring-one]
   [+ ring-add] [- ring-subtract] [negate ring-negate] [* ring-multiply])
  ["addition commutes" (x y) (+ x y) (+ y x)]
  ["addition associates" (x y z) (+ (+ x y) z) (+ x (+ y z))]
  ["zero is neutral on the right" (x) (+ x zero) x]
  ["zero is neutral on the left" (x) (+ zero x) x]
  ["a negative cancels" (x) (+ x (negate x)) (- x x)]
  ["a difference is the sum with the negative" (x y) (- x y) (+ x (negate y))]
  ["subtraction undoes addition" (x y) (- (+ x y) y) x]
  ["multiplication associates" (x y z) (* (* x y) z) (* x (* y z))]
  ["one is neutral on the right" (x) (* x one) x]
  ["one is neutral on the left" (x) (* one x) x]
  ["zero times anything plus it is it" (x y) (+ (* zero x) y) y]
  ["multiplication distributes on the left" (x y z) (* x (+ y z)) (+ (* x y) (* x z))]
  ["multiplication distributes on the right" (x y z) (* (+ x y) z) (+ (* x z) (* y z))]
  ["signs move across products" (x y) (* (negate x) y) (negate (* x y))])

(define-laws commutativity-laws
  ([* ring-multiply])
  ["multiplication commutes" (x y) (* x y) (* y x)])

(define-laws power-laws
  ([one ring-one] [* ring-multiply] [square ring-square] [expt ring-expt])
  ["a square is a product" (x) (square x) (* x x)]
  ["the second power is the square" (x) (expt x 2) (square x)]
  ["the third power is a product of three" (x) (expt x 3) (* x (* x x))]
  ["powers of one thing multiply by adding exponents" (x) (* (expt x 2) (expt x 3)) (expt x 5)]
  ["the zeroth power is one" (x y) (* (expt x 0) y) y]
  ["the first power is the thing" (x) (expt x 1) x])

(define-laws division-laws
  ([one ring-one] [+ ring-add] [* ring-multiply] [/ ring-divide] [expt ring-expt])
  ["division undoes multiplication" (x y) (/ (* x y) y) x]
  ["an inverse cancels" (x y) (* (* (/ one x) x) y) y]
  ["a quotient is a product with the inverse" (x y) (/ x y) (* x (/ one y))]
  ["quotients over one denominator add" (x y z) (/ (+ x y) z) (+ (/ x z) (/ y z))]
  ["the inverse of the inverse is the thing" (x) (/ one (/ one x)) x]
  ["inverses multiply, the last one first" (x y) (/ one (* x y)) (* (/ one y) (/ one x))]
  ["a negative power is the inverse" (x) (expt x -1) (/ one x)])

;; ---------------------------------------------------------------------------
;; Every law seen to fail, over the rationals

(module+ test
  (require "../random.rkt")

  (define right
    (ring 0 1 + - - * / (lambda (x) (* x x)) expt))

  (define all-laws (append ring-laws commutativity-laws power-laws division-laws))
  (check-laws "rationals under Racket's operations" all-laws right random-rational = #:seed 11)

  (define (broken name wrong)
    (check-broken name all-laws wrong random-rational = #:seed 12))
  (define-syntax-rule (with field value) (struct-copy ring right [field value]))

  (define (lopsided + x y) (+ x (* 2 y)))
  (define (inverted x y) (- y x))
  (broken "addition commutes" (with add (lambda (x y) (lopsided + x y))))
  (broken "addition associates" (with add (lambda (x y) (/ (+ x y) 2))))
  (broken "zero is neutral on the right" (with zero 1))
  (broken "zero is neutral on the left" (with zero 1))
  (broken "a negative cancels" (with negate abs))
  (broken "a difference is the sum with the negative" (with subtract inverted))
  (broken "subtraction undoes addition" (with subtract inverted))
  (broken "multiplication associates" (with multiply (lambda (x y) (+ (* x y) y))))
  (broken "one is neutral on the right" (with one -1))
  (broken "one is neutral on the left" (with one -1))
  (broken "zero times anything plus it is it" (with multiply (lambda (x y) (+ (* x y) y))))
  (broken "multiplication distributes on the left"
          (with multiply (lambda (x y) (* x y y))))
  (broken "multiplication distributes on the right"
          (with multiply (lambda (x y) (* x x y))))
  (broken "signs move across products" (with multiply (lambda (x y) (* (abs x) y))))
  (broken "multiplication commutes" (with multiply (lambda (x y) (* x (abs y)))))
  (broken "a square is a product" (with square abs))
  (broken "the second power is the square" (with square abs))
  (broken "the third power is a product of three" (with expt (lambda (x n) (* n x))))
  (broken "powers of one thing multiply by adding exponents"
          (with expt (lambda (x n) (* n x))))
  (broken "the zeroth power is one" (with expt (lambda (x n) (* n x))))
  (broken "the first power is the thing" (with expt (lambda (x n) (expt x (add1 n)))))
  (broken "division undoes multiplication" (with divide (lambda (x y) (/ y x))))
  (broken "an inverse cancels" (with divide (lambda (x y) (/ x (* 2 y)))))
  (broken "a quotient is a product with the inverse" (with divide (lambda (x y) (/ y x))))
  (broken "quotients over one denominator add" (with divide (lambda (x y) (/ x (* x y)))))
  (broken "the inverse of the inverse is the thing" (with divide (lambda (x y) (/ x (* y y)))))
  (broken "inverses multiply, the last one first" (with divide (lambda (x y) (/ x (* 2 y)))))
  (broken "a negative power is the inverse" (with expt (lambda (x n) (expt x (abs n))))))
