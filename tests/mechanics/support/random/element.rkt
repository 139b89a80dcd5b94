#lang racket/base
;; Random elements of every kind of value.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/value/operator
         mechanics/value/series/series-access
         mechanics/calculus/dual
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../random.rkt"
         "../laws/derivation.rkt" "../laws/ring.rkt")

(provide generic-ring
         random-expression random-dual random-matrix random-operator random-real-function
         random-up random-nested random-series)

(define generic-ring (ring 0 1 g:+ g:- g:negate g:* g:/ g:square g:expt))

(define (random-expression [depth 2])
  (define (part) (random-expression (sub1 depth)))
  (case (if (zero? depth) (random 3) (random 9))
    [(0 1) (random-choice 'a 'b 'c)]
    [(2) (random-rational)]
    [(3) (g:+ (part) (part))]
    [(4) (g:* (part) (part))]
    [(5) (g:- (part) (g:/ (part) 'c))]
    [(6) (g:sin (part))]
    [(7) (g:expt (random-choice 'a 'b) (random-integer -2 3))]
    [(8) ((literal-function (random-choice 'f 'g)) (part))]))

;; x + x' ε for one or two of two ε, of which the second is the outer one.
(define (random-dual [scalar random-rational])
  (define (inner) (make-dual 3 (scalar) (scalar)))
  (case (random 3)
    [(0) (inner)]
    [(1) (make-dual 5 (scalar) (scalar))]
    [(2) (make-dual 5 (inner) (inner))]))

(define (random-matrix [scalar random-rational] [n 2])
  (m:generate n n (lambda (i j) (scalar))))

(define (random-real-function)
  (if (zero? (random 4))
      (literal-function (random-choice 'F 'G))
      (random-function 2)))

(define (random-operator)
  (define f (random-function 1))
  (random-choice D
                 (g:* f D)
                 (g:+ D (random-rational))
                 (g:- (g:* (random-rational) D) f)
                 (make-operator (lambda (g) (lambda (x) (g (g:* 2 x)))) 'stretch)))

(define ((random-up scalar)) (up (scalar) (scalar) (scalar)))
(define ((random-nested scalar))
  (up (scalar) (down (scalar) (up (scalar) (scalar))) (scalar)))

;; Power series that end and that do not, which do not begin with 0.
(define (random-series [scalar random-rational])
  (define p (power-series (scalar) (scalar) (scalar)))
  (case (random 4)
    [(0) p]
    [(1) (g:/ (scalar) p)]
    [(2) (g:* (scalar) (g:exp (g:- p (series:ref p 0))))]
    [(3) (g:+ p (g:/ (power-series 0 (scalar)) (power-series (scalar) (scalar))))]))
