#lang racket/base
;; Equality, zero and one, and order.

(require mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/calculus/derivative
         mechanics/calculus/dual
         mechanics/calculus/literal-function
         mechanics/compile/definite-integral
         "../support/checks.rkt")

(define V (literal-function 'V))

;; ---------------------------------------------------------------------------
;; Equality

(test-case "a multiple of π has its place among numbers"
  (define 2π (g:* 2 ':pi))
  (check-true (g:< 6 2π 7))
  (check-false (g:< 2π 6))
  (check-false (g:>= 2π 7))
  (check-false (g:negative? 2π)))

(test-case "numbers are equal as numbers"
  (check-true (g:= 1 1.0))
  (check-true (g:= 1/2 0.5 (/ 2 4)))
  (check-false (g:= 1 2))
  (check-false (g:= 1 2 2))
  (check-false (g:= +nan.0 +nan.0))
  (check-true (g:= 3)))

(test-case "expressions are equal when they are written alike, up to order in sums and products"
  (check-true (g:= 'a 'a))
  (check-false (g:= 'a 'b))
  (check-true (g:= (g:+ 'a 'b) (g:+ 'b 'a)))
  (check-true (g:= (g:* 2 'a (g:sin 'b)) (g:* (g:sin 'b) 2 'a)))
  (check-false (g:= (g:- 'a 'b) (g:- 'b 'a)))
  (check-false (g:= 'a 1))
  (check-true (g:= (V 't) (V 't))))

(test-case "tuples are equal component by component, orientation included"
  (check-true (g:= (up 1 'a) (up 1.0 'a)))
  (check-true (g:= (up 1 2) (vector 1 2)))
  (check-true (g:= (vector 1 (up 2 3)) (up 1 (vector 2 3))))
  (check-false (g:= (up 1 2) (down 1 2)))
  (check-false (g:= (up 1 2) (up 1 2 3)))
  (check-false (g:= (up 1) 1)))

(test-case "equality of several values is that of all neighbours"
  (check-true (g:= 'a 'a 'a))
  (check-false (g:= 'a 'a 'b)))

(test-case "functions are equal when they are one, or literal ones of one name"
  (check-true (g:= sin sin))
  (check-true (g:= V (literal-function 'V)))
  (check-false (g:= V (literal-function 'W)))
  (check-false (g:= sin cos)))

(test-case "unlike kinds are not equal, and asking is no error"
  (for* ([a (list 1 'a (up 1 2) sin (matrix-by-rows '(1)) D '(1))]
         [b (list 1 'a (up 1 2) sin (matrix-by-rows '(1)) D '(1))])
    (check-equal? (g:= a b) (equal? a b))))

(test-case "equal? sees orientation, and hashing agrees with it"
  (check-equal? (up 1 (down 'a 2)) (up 1 (down 'a 2)))
  (check-not-equal? (up 1 2) (down 1 2))
  (check-equal? (hash-ref (hash (up 1 (g:+ 'a 'b)) 'found) (up 1 (g:+ 'b 'a)) #f) 'found)
  (check-false (hash-ref (hash (up 1 2) 'found) (down 1 2) #f)))

;; ---------------------------------------------------------------------------
;; Zero and one

(test-case "zero is decided for numbers, tuples and matrices; an expression is never zero"
  (check-true (g:zero? 0))
  (check-true (g:zero? -0.0))
  (check-true (g:zero? (up 0 (down 0.0 0))))
  (check-true (g:zero? (vector 0 0)))
  (check-true (g:zero? (matrix-by-rows '(0 0) '(0 0))))
  (for ([x (list 1 1e-300 'a (g:- 'a 'b) (up 0 1) (matrix-by-rows '(0 1)) sin D)])
    (check-false (g:zero? x)))
  (for ([x (list "0" '())])
    (check-exn #rx"^zero[?]: expected a value of the arithmetic" (lambda () (g:zero? x)))))

(test-case "one? is for numbers"
  (check-true (g:one? 1))
  (check-true (g:one? 1.0))
  (for ([x (list 0 'a (up 1) sin)]) (check-false (g:one? x))))

;; ---------------------------------------------------------------------------
;; Order

(test-case "real numbers are ordered, several at once"
  (check-true (g:< 1 2 3))
  (check-false (g:< 1 3 2))
  (check-true (g:<= 1 1.0 2))
  (check-true (g:> 3 2 1))
  (check-true (g:>= 3 3 1))
  (check-false (g:< +nan.0 1)))

(test-case "signs, greatest and least"
  (check-true (g:positive? 1/2))
  (check-false (g:positive? 0))
  (check-true (g:negative? -0.5))
  (check-equal? (g:max 1 3 2) 3)
  (check-equal? (g:min 2 1 3) 1)
  (check-equal? (g:max 1 2.0) 2.0)
  (check-equal? (g:max 5) 5))

(test-case "add1 and sub1 are sums"
  (check-equal? (g:add1 1/2) 3/2)
  (check-equal? (g:sub1 'a) (g:- 'a 1))
  (check-equal? ((g:add1 sin) 0) 1))

;; ---------------------------------------------------------------------------
;; Dual numbers are compared by their values

(define x+dx (make-dual 1 2 1))
(define nested (make-dual 2 (make-dual 1 2 1) 1))

(test-case "a dual number is compared as the number it is near"
  (for ([d (list x+dx nested)])
    (check-true (g:= d 2))
    (check-true (g:< 1 d 3))
    (check-true (g:positive? d))
    (check-false (g:zero? d))
    (check-true (g:zero? (g:- d 2)))
    (check-true (g:one? (g:/ d 2)))
    (check-true (g:= (up d 1) (up 2 1)))))

(test-case "so that code which branches has derivatives"
  (define (clamp x) (cond [(g:< x 0) 0] [(g:<= x 1) (g:square x)] [else (g:- (g:* 2 x) 1)]))
  (check-equal? (map (D clamp) '(-1 1/2 2)) '(0 1 2))
  (check-equal? ((D (lambda (x) (g:max x (g:square x)))) 3) 6)
  (check-equal? ((D (lambda (x) (g:min x (g:square x)))) 3) 1)
  (check-equal? ((D (lambda (x) (if (g:zero? x) x (g:* 2 x)))) 0) 1))

(test-case "the symbol in a dual number has no order either"
  (check-exn #rx"^<: an expression that is not a number has no order.*value: the symbol a$"
             (lambda () ((D (lambda (x) (if (g:< x 0) 0 x))) 'a))))

;; Σ over x from 0 to 1 of f(x, a), as a function of a
(define ((integral f) a) (definite-integral (lambda (x) (f x a)) 0 1))

(test-case "a choice by a sign is made elsewhere when what it depends on moves"
  (define (slope f) ((D (integral f)) 0.3))
  (check-= (slope (lambda (x a) (if (g:negative? (g:- x a)) 1 0))) 1 1e-9)      ; a
  (check-= (slope (lambda (x a) (if (g:positive? (g:- x a)) 1 0))) -1 1e-9)     ; 1 - a
  (check-= (slope g:max) 0.3 1e-9)                                              ; (1 + a^2)/2
  (check-= (slope g:min) 0.7 1e-9))                                             ; a - a^2/2
