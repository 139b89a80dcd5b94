#lang racket/base
;; The test of the first edition took a gradient of symbols x0, x1, …, which may be the names of
;; the state's own coordinates and of parameters: terms then cancelled, and a transformation that
;; is not canonical passed.

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

;; Momenta stay as they are: canonical for a = b = 0 alone
(define ((sheared a b) (up t (up x y) p))
  (up t (up (+ x (* b (/ x y))) (- y (* a (/ x y)))) p))

(define (residual a b x y)
  ((time-independent-canonical? (sheared a b)) (up 't (up x y) (down 'p 'P))))

(test-case "x ∂h/∂x + y ∂h/∂y = 0 and a b − b a = 0, where the gradient is (a, b, x, y) itself"
  (define g (compatible-shape (up 't (up 'x 'y) (down 'p 'P))))
  (check-equal? g (down 'x0 (down 'x1 'x2) (up 'x3 'x4)))
  (for ([names '((x1 x2 x3 x4) (x1 x2 x y) (a b x3 x4) (a b x y))])
    (check-pred refuted? (prove-zero (apply residual names))))
  (check-identity (residual 0 0 'x3 'x4) (up 0 (up 0 0) (down 0 0))))
