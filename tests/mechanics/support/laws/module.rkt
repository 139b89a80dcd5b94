#lang racket/base
;; The laws of modules: things one can add and multiply by scalars, with a
;; product that takes two of them to a scalar.

(require mechanics/generic/arithmetic
         mechanics/generic/up-down
         (only-in mechanics/value/structure dot-product)
         "law.rkt"
         "../random.rkt")

(provide (struct-out module-operations) generic-module module-laws pairing-laws draw-with-scalars)

;; pair : element element -> scalar, linear in both
(struct module-operations (add subtract negate scale unscale pair))

(define generic-module
  (module-operations g:+ g:- g:negate g:* g:/ dot-product))

;; Elements drawn in turn: a and b are scalars, the others elements; so the draw
;; gives a pair of both, and laws take what they need.
(define (draw-with-scalars scalar element) (lambda () (cons (scalar) (element))))

(define-syntax-rule (define-module-laws id ([local accessor] ...)
                      [name (a ...) (x ...) left right] ...)
  (define-laws id ([local accessor] ...)
    [name (a ... x ...)
          (let ([a (car a)] ... [x (cdr x)] ...) left)
          (let ([a (car a)] ... [x (cdr x)] ...) right)] ...))

(define-module-laws module-laws
  ([+ module-operations-add] [- module-operations-subtract] [negate module-operations-negate]
   [* module-operations-scale] [/ module-operations-unscale])
  ["addition commutes" () (x y) (+ x y) (+ y x)]
  ["addition associates" () (x y z) (+ (+ x y) z) (+ x (+ y z))]
  ["a negative cancels" () (x y) (+ (+ x (negate x)) y) y]
  ["a difference is the sum with the negative" () (x y) (- x y) (+ x (negate y))]
  ["exact zero is neutral" () (x) (+ x 0) (+ 0 x)]
  ["scaling distributes over elements" (a) (x y) (* a (+ x y)) (+ (* a x) (* a y))]
  ["scaling distributes over scalars" (a b) (x) (* (g:+ a b) x) (+ (* a x) (* b x))]
  ["scaling twice is scaling by the product" (a b) (x) (* (g:* a b) x) (* a (* b x))]
  ["scaling by one is nothing" () (x) (* 1 x) x]
  ["scalars commute with elements" (a) (x) (* a x) (* x a)]
  ["division undoes scaling" (a) (x) (/ (* a x) a) x])

(define-module-laws pairing-laws
  ([+ module-operations-add] [* module-operations-scale] [pair module-operations-pair])
  ["the pairing is additive on the right" () (x y z) (pair x (+ y z)) (g:+ (pair x y) (pair x z))]
  ["the pairing is additive on the left" () (x y z) (pair (+ x y) z) (g:+ (pair x z) (pair y z))]
  ["scalars come out on the right" (a) (x y) (pair x (* a y)) (g:* a (pair x y))]
  ["scalars come out on the left" (a) (x y) (pair (* a x) y) (g:* a (pair x y))]
  ["the pairing is symmetric" () (x y) (pair x y) (pair y x)])

;; ---------------------------------------------------------------------------
;; Every law seen to fail, on pairs of rationals

(module+ test
  (define draw
    (draw-with-scalars random-rational
                       (lambda () (up (random-rational) (random-rational)))))
  (define laws (append module-laws pairing-laws))
  (check-laws "pairs of rationals" laws generic-module draw equal? #:seed 21)

  (define (broken name wrong) (check-broken name laws wrong draw equal? #:seed 22))
  (define-syntax-rule (with field value)
                      (struct-copy module-operations generic-module [field value]))
  (define (halves f) (lambda (x y) (g:/ (f x y) 2)))
  (define (flip s) (structure (structure-orientation s)
                              (list->vector (reverse (vector->list (structure-elements s))))))
  (define (size x) (if (tuple? x) (dot-product x x) x))

  (broken "addition commutes" (with add (lambda (x y) (g:+ x (g:* 2 y)))))
  (broken "addition associates" (with add (halves g:+)))
  (broken "a negative cancels" (with negate values))
  (broken "a difference is the sum with the negative" (with subtract (lambda (x y) (g:- y x))))
  (broken "exact zero is neutral" (with add (lambda (x y) (if (eqv? y 0) (g:* 2 x) (g:+ x y)))))
  (broken "scaling distributes over elements"
          (with scale (lambda (a x) (g:* a (g:* (size x) x)))))
  (broken "scaling distributes over scalars" (with scale (lambda (a x) (g:* a (g:* a x)))))
  (broken "scaling twice is scaling by the product" (with scale (lambda (a x) (g:* a (flip x)))))
  (broken "scaling by one is nothing" (with scale (lambda (a x) (g:* 2 (g:* a x)))))
  (broken "scalars commute with elements"
          (with scale (lambda (a x) (if (tuple? a) (g:negate (g:* a x)) (g:* a x)))))
  (broken "division undoes scaling" (with unscale (lambda (x a) (g:* x a))))
  (broken "the pairing is additive on the right" (with pair (lambda (x y) (g:* (size y) (size x)))))
  (broken "the pairing is additive on the left" (with pair (lambda (x y) (g:* (size y) (size x)))))
  (broken "scalars come out on the right" (with pair (lambda (x y) (g:+ 1 (dot-product x y)))))
  (broken "scalars come out on the left" (with pair (lambda (x y) (g:+ 1 (dot-product x y)))))
  (broken "the pairing is symmetric"
          (with pair (lambda (x y) (g:* (vector-ref (structure-elements x) 0)
                                        (vector-ref (structure-elements y) 1))))))
