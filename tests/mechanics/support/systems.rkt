#lang racket/base
;; Lagrangians and paths that several tests use, over generic arithmetic.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/structure
         mechanics/calculus/literal-function
         mechanics/lagrangian/local-tuple)

(provide L-free L-harmonic L-central-polar L-orbital L-planar straight-line literal-plane-path)

(define ((L-free m) local) (g:* 1/2 m (g:square (velocity local))))

(define ((L-harmonic m k) local)
  (g:- (g:* 1/2 m (g:square (velocity local))) (g:* 1/2 k (g:square (coordinate local)))))

;; 1/2 m v² - U(x, y)
(define ((L-planar m U) local)
  (define q (coordinate local))
  (g:- (g:* 1/2 m (g:square (velocity local))) (U (ref q 0) (ref q 1))))

(define (L-orbital m mu)
  (L-planar m (lambda (x y) (g:/ (g:negate mu) (g:sqrt (g:+ (g:square x) (g:square y)))))))

;; 1/2 m (ṙ² + r² φ̇²) - U(r)
(define ((L-central-polar m U) local)
  (define r (ref (coordinate local) 0))
  (define v (velocity local))
  (g:- (g:* 1/2 m (g:+ (g:square (ref v 0)) (g:square (g:* r (ref v 1))))) (U r)))

(define (straight-line t)
  (up (g:+ (g:* 'a t) 'a0) (g:+ (g:* 'b t) 'b0) (g:+ (g:* 'c t) 'c0)))

(define literal-plane-path (up (literal-function 'x) (literal-function 'y)))
