#lang racket/base
;; Square-free decomposition, by Yun's algorithm one variable after the other.

(require "arithmetic.rkt" "content.rkt" "division.rkt" "gcd.rkt" "polynomial-parts.rkt" "power.rkt")

(provide poly-square-free)

;; Powers of factors: primitive, square-free, pairwise coprime, not constant; their
;; product is p up to a rational factor.  Several may have one exponent.
(define (poly-square-free R p)
  (define variables (poly-variables R p))
  (cond [(null? variables) '()]
        [else
         (define x (car variables))
         (define content (poly-content-in R p x))
         (define primitive (poly-primitive-part R (poly-divide R p content)))
         (append (yun R primitive x) (poly-square-free R content))]))

;; p without factors free of x.  With p = ∏ fᵢ^i, p/gcd(p, p') is ∏ fᵢ; comparing
;; derivatives then frees f₁, f₂, ... in turn.
(define (yun R p x)
  (define g (poly-gcd R p (poly-derivative R p x)))
  (let loop ([w (poly-divide R p g)] [y (poly-divide R (poly-derivative R p x) g)] [i 1])
    (cond [(poly-constant? w) '()]
          [else
           (define z (poly- R y (poly-derivative R w x)))
           (define f (poly-gcd R w z))
           (define rest (loop (poly-divide R w f) (poly-divide R z f) (+ i 1)))
           (if (poly-constant? f) rest (cons (make-power f i) rest))])))
