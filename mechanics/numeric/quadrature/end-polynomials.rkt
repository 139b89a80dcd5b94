#lang racket/base
;; Polynomials on [−1, 1] that vanish at both ends, and their derivatives: the integrals
;; of the Legendre polynomials,
;;
;;     φₖ(u) = ∫ Pₖ du = (Pₖ₊₁ − Pₖ₋₁)/(2k + 1),     k = 1, 2, …,
;;
;; here times √((2k + 1)/2), so that the derivatives are orthonormal.  The first n are a
;; basis of all those of degree n + 1; a sum Σ cₖ φₖ has Σ cₖ² as integral of the square of
;; its derivative.

(require racket/flonum)

(provide end-polynomials)

;; -> two flvectors, the values of the first n of them at u and of their derivatives
(define (end-polynomials n u)
  (define basis (make-flvector n))
  (define slopes (make-flvector n))
  (for/fold ([before 1.0] [p u]) ([k (in-range 1 (+ n 1))])
    (define 2k+1 (->fl (+ 1 (* 2 k))))
    (define next (fl/ (fl- (fl* (fl* 2k+1 u) p) (fl* (->fl k) before)) (->fl (+ k 1))))
    (define scale (flsqrt (fl* 0.5 2k+1)))
    (flvector-set! basis (- k 1) (fl* scale (fl/ (fl- next before) 2k+1)))
    (flvector-set! slopes (- k 1) (fl* scale p))
    (values p next))
  (values basis slopes))
