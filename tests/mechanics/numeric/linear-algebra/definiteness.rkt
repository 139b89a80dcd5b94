#lang racket/base
;; Quadratic forms that fall below zero, and polynomials that vanish at both ends.

(require racket/flonum
         mechanics/numeric/linear-algebra/definiteness
         mechanics/numeric/quadrature/end-polynomials
         mechanics/numeric/quadrature/gauss-rule
         "../../support/checks.rkt")

;; ---------------------------------------------------------------------------
;; Quadratic forms

(define n 6)

;; Aᵀ D A, with a random A
(define (form diagonal generator)
  (define A (for/vector ([_ n]) (for/vector ([_ n]) (- (random generator) 0.5))))
  (define (a i j) (vector-ref (vector-ref A i) j))
  (for/vector ([i n])
    (for/vector ([j n])
      (for/sum ([d (in-list diagonal)] [k n]) (* d (a k i) (a k j))))))

(test-case "by the signs of a diagonal form that it comes from"
  (define seed 20261)
  (define generator (make-pseudo-random-generator))
  (parameterize ([current-pseudo-random-generator generator]) (random-seed seed))
  (for ([_ 200])
    (with-check-info (['seed seed])
      (check-false (takes-negative-values? (form '(1 2 3 4 5 6) generator)))
      (check-false (takes-negative-values? (form '(1 2 3 0 0 0) generator)))
      (check-true (takes-negative-values? (form '(1 2 3 4 5 -60) generator)))
      (check-true (takes-negative-values? (form '(-1 -1 -1 -1 -1 -1) generator))))))

(test-case "small cases"
  (check-false (takes-negative-values? '#(#(0.0 0.0) #(0.0 0.0))))
  (check-false (takes-negative-values? '#(#(1.0 0.0) #(0.0 -1e-9))) "rounding")
  (check-true (takes-negative-values? '#(#(1.0 0.0) #(0.0 -1e-5))))
  (check-true (takes-negative-values? '#(#(0.0 1.0) #(1.0 0.0))))
  (check-true (takes-negative-values? '#(#(1.0 2.0) #(2.0 1.0))))
  (check-false (takes-negative-values? '#())))

;; ---------------------------------------------------------------------------
;; Polynomials

(test-case "they vanish at the ends"
  (for* ([u '(-1.0 1.0)])
    (define-values (basis slopes) (end-polynomials 12 u))
    (for ([b (in-flvector basis)]) (check-= b 0 1e-15))))

(test-case "the first two are (u² − 1)/2 and (u³ − u)/2, times √(3/2) and √(5/2)"
  (define u 0.3)
  (define-values (basis slopes) (end-polynomials 2 u))
  (check-= (flvector-ref basis 0) (* (sqrt 1.5) 0.5 (- (* u u) 1)) 1e-15)
  (check-= (flvector-ref basis 1) (* (sqrt 2.5) 0.5 (- (* u u u) u)) 1e-15)
  (check-= (flvector-ref slopes 0) (* (sqrt 1.5) u) 1e-15)
  (check-= (flvector-ref slopes 1) (* (sqrt 2.5) 0.5 (- (* 3 u u) 1)) 1e-15))

(test-case "their derivatives are orthonormal"
  (define-values (nodes weights) (gauss-legendre-rule 20))
  (for* ([i 10] [j 10])
    (define product
      (for/sum ([u (in-flvector nodes)] [w (in-flvector weights)])
        (define-values (basis slopes) (end-polynomials 10 u))
        (* w (flvector-ref slopes i) (flvector-ref slopes j))))
    (check-= product (if (= i j) 1 0) 1e-13)))
