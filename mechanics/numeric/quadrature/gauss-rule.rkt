#lang racket/base
;; The nodes and weights of Gauss and Legendre's rule on [−1, 1], for any number of
;; nodes: ∫ f ≈ Σ wᵢ f(xᵢ), exact for polynomials of degree 2n − 1.
;;
;; The nodes are the zeros of the Legendre polynomial Pₙ.  Newton's method finds
;; each from cos(π (i − 1/4)/(n + 1/2)), where it lies nearly (Tricomi); Pₙ and
;; Pₙ₋₁ come from the recurrence k Pₖ = (2k − 1) x Pₖ₋₁ − (k − 1) Pₖ₋₂, and with
;; Pₙ' = n (x Pₙ − Pₙ₋₁)/(x² − 1) the weight is 2/((1 − x²) Pₙ'²).

(require racket/flonum
         "../constants.rkt")

(provide gauss-legendre-rule)

;; -> nodes and weights, flvectors of length n
(define (gauss-legendre-rule n)
  (define nodes (make-flvector n))
  (define weights (make-flvector n))
  (for ([i (in-range n)])
    (define x (refine n (cos (/ (* pi (- (+ i 1.0) 0.25)) (+ n 0.5)))))
    (define-values (p slope) (legendre n x))
    (flvector-set! nodes (- n 1 i) x)
    (flvector-set! weights (- n 1 i) (/ 2.0 (* (- 1.0 (* x x)) slope slope))))
  (values nodes weights))

(define (refine n x)
  (let loop ([x x] [left 10])
    (define-values (p slope) (legendre n x))
    (define step (/ p slope))
    (if (or (= left 0) (< (abs step) 1e-16))
        (- x step)
        (loop (- x step) (- left 1)))))

;; Pₙ(x) and its derivative
(define (legendre n x)
  (define-values (p before)
    (for/fold ([p x] [before 1.0]) ([k (in-range 2 (+ n 1))])
      (values (/ (- (* (- (* 2 k) 1) x p) (* (- k 1) before)) k) p)))
  (values p (/ (* n (- (* x p) before)) (- (* x x) 1.0))))
