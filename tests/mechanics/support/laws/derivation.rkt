#lang racket/base
;; The laws of derivations: linearity, product, quotient, chain and powers, the
;; inverse function, and partial derivatives that commute.
;;
;; Elements are drawn as pairs of a number, where to look, and a function of one
;; variable; the two sides are values at the number.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         "law.rkt"
         "../random.rkt")

(provide (struct-out derivation) derivation-laws partial-laws
         random-function random-function-of-two draw-functions)

;; of      : f -> x -> f'(x)
;; partial : i f -> x y -> the derivative by argument i
(struct derivation (of partial))

(define-laws derivation-laws
  ([D derivation-of])
  ["constants have derivative zero" (f)
   ((D (lambda (x) (number f))) (number f)) 0]
  ["the identity has derivative one" (f)
   ((D values) (number f)) 1]
  ["derivatives add" (f g)
   (at f (D (sum f g)))
   (g:+ (at f (D (fn f))) (at f (D (fn g))))]
  ["constant factors come out" (f c)
   (at f (D (lambda (x) (g:* (number c) ((fn f) x)))))
   (g:* (number c) (at f (D (fn f))))]
  ["the product rule" (f g)
   (at f (D (product f g)))
   (g:+ (g:* (at f (D (fn f))) (at f (fn g))) (g:* (at f (fn f)) (at f (D (fn g)))))]
  ["the quotient rule" (f g)
   (at f (D (lambda (x) (g:/ ((fn f) x) (g:exp ((fn g) x))))))
   (g:/ (g:- (at f (D (fn f))) (g:* (at f (fn f)) (at f (D (fn g)))))
        (g:exp (at f (fn g))))]
  ["the chain rule" (f g)
   (at f (D (lambda (x) ((fn g) ((fn f) x)))))
   (g:* ((D (fn g)) (at f (fn f))) (at f (D (fn f))))]
  ["the rule of powers" (f)
   (at f (D (lambda (x) (g:expt ((fn f) x) 3))))
   (g:* 3 (g:square (at f (fn f))) (at f (D (fn f))))]
  ["an inverse function has the inverse derivative" (f)
   (for/fold ([product 1]) ([pair (in-list inverse-pairs)])
     (define x (g:/ (g:sin (number f)) 2))       ; where all have inverses
     (g:* product
          ((D (car pair)) x)
          ((D (cdr pair)) ((car pair) x))))
   1]
  ["the second derivative of a product" (f g)
   (at f (D (D (product f g))))
   (g:+ (g:* (at f (D (D (fn f)))) (at f (fn g)))
        (g:* 2 (at f (D (fn f))) (at f (D (fn g))))
        (g:* (at f (fn f)) (at f (D (D (fn g))))))])

(define inverse-pairs
  (list (cons g:exp g:log)
        (cons g:tan g:atan)
        (cons g:sin g:asin)
        (cons g:sinh (lambda (x) (g:log (g:+ x (g:sqrt (g:+ 1 (g:square x)))))))))

(define number car)
(define fn cdr)
(define (at f g) (g (number f)))
(define (sum f g) (lambda (x) (g:+ ((fn f) x) ((fn g) x))))
(define (product f g) (lambda (x) (g:* ((fn f) x) ((fn g) x))))

;; Elements are pairs of a number and a function of two variables.
(define-laws partial-laws
  ([partial derivation-partial])
  ["partial derivatives commute" (f g)
   (at-both f g (partial 0 (partial 1 (fn f))))
   (at-both f g (partial 1 (partial 0 (fn f))))]
  ["a partial derivative sees one argument" (f g)
   (at-both f g (partial 0 (lambda (x y) (g:* (g:exp y) (g:+ x y)))))
   (g:exp (number g))]
  ["along the diagonal partial derivatives add" (f g)
   ((partial 0 (lambda (t u) ((fn f) t t))) (number f) 0)
   (g:+ ((partial 0 (fn f)) (number f) (number f)) ((partial 1 (fn f)) (number f) (number f)))])

(define (at-both f g h) (h (number f) (number g)))

;; ---------------------------------------------------------------------------
;; Random functions, smooth everywhere and not too steep

(define (random-function [depth 3])
  (define (part) (random-function (sub1 depth)))
  (case (if (zero? depth) (random 2) (random 8))
    [(0) values]
    [(1) (let ([c (random-rational)]) (lambda (x) (g:+ x c)))]
    [(2) (let ([f (part)]) (lambda (x) (g:sin (f x))))]
    [(3) (let ([f (part)]) (lambda (x) (g:cos (f x))))]
    [(4) (let ([f (part)] [g (part)]) (lambda (x) (g:+ (f x) (g x))))]
    [(5) (let ([f (part)]) (lambda (x) (g:/ (f x) (g:+ 2 (g:square (g:sin x))))))]
    [(6) (let ([f (part)]) (lambda (x) (g:atan (f x))))]
    [(7) (let ([f (part)] [c (random-rational)]) (lambda (x) (g:* c (g:tanh (f x)))))]))

(define (random-function-of-two)
  (define f (random-function 2))
  (define g (random-function 2))
  (define h (random-function 2))
  (lambda (x y) (g:+ (g:* (f x) (g y)) (h (g:* x y)))))

(define ((draw-functions number function)) (cons (number) (function)))

;; ---------------------------------------------------------------------------
;; Every law seen to fail, on central differences of differences

(module+ test
  (require "../same.rkt")

  ;; A derivation that is right to five digits and knows nothing of ours.
  (define h 1e-3)
  (define ((numeric-D f) x)
    (/ (- (* 8 (- (f (+ x h)) (f (- x h)))) (- (f (+ x h h)) (f (- x h h)))) (* 12 h)))
  (define (numeric-partial i f)
    (lambda (x y)
      (if (eqv? i 0)
          ((numeric-D (lambda (u) (f u y))) x)
          ((numeric-D (lambda (u) (f x u))) y))))
  (define right (derivation numeric-D numeric-partial))
  (define tolerance (close-to 1e-4))

  (define draw (draw-functions random-flonum random-function))
  (define draw-two (draw-functions random-flonum random-function-of-two))
  (check-laws "central differences" derivation-laws right draw tolerance #:seed 31)
  (check-laws "central differences" partial-laws right draw-two tolerance #:seed 32)

  (define (broken name D)
    (check-broken name derivation-laws (derivation D numeric-partial) draw tolerance #:seed 33))
  (define (doubled f) (lambda (x) (* 2 ((numeric-D f) x))))
  (define (squared f) (lambda (x) (expt ((numeric-D f) x) 2)))
  (define (undone f) f)
  (broken "constants have derivative zero" undone)
  (broken "the identity has derivative one" doubled)
  (broken "derivatives add" squared)
  (broken "constant factors come out" squared)
  (broken "the product rule" undone)
  (broken "the quotient rule" undone)
  (broken "the chain rule" doubled)
  (broken "the rule of powers" undone)
  (broken "an inverse function has the inverse derivative" doubled)
  (broken "the second derivative of a product" undone)

  (define (broken-partial name partial)
    (check-broken name partial-laws (derivation numeric-D partial) draw-two tolerance #:seed 34))
  (broken-partial "partial derivatives commute"
                  (lambda (i f) (if (eqv? i 0) (numeric-partial 0 f) (lambda (x y) (* x (f x y))))))
  (broken-partial "a partial derivative sees one argument"
                  (lambda (i f)
                    (lambda (x y) (+ ((numeric-partial 0 f) x y) ((numeric-partial 1 f) x y)))))
  (broken-partial "along the diagonal partial derivatives add"
                  (lambda (i f) (numeric-partial 0 f))))
