#lang racket/base
;; The operators of vector calculus on functions of rectangular coordinates, (up x y z).

(require "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt"
         "../value/operator.rkt" "../value/structure.rkt")

(provide Grad Div Curl Lap)

(define-syntax-rule (define-flat name (f x) value)
  (define name
    (make-operator (lambda (f)
                     (make-function (lambda (x) value) 2
                                    (lambda () (list 'name (value->datum f)))))
                   'name)))

(define-flat Grad (f x) (flip ((D f) x)))

(define-flat Div (F x)
  (g:for/sum ([i (in-range (s:length x))]) (ref ((D F) x) i i)))

(define-flat Curl (F x)
  (let ([slopes ((D F) x)])
    (define (slope j i) (ref slopes i j))          ; ∂ᵢFⱼ
    (up (g:- (slope 2 1) (slope 1 2)) (g:- (slope 0 2) (slope 2 0)) (g:- (slope 1 0) (slope 0 1)))))

(define-flat Lap (f x) ((Div (Grad f)) x))
