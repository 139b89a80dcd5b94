#lang racket/base
;; Gauss and Legendre's rule.

(require racket/flonum
         mechanics/numeric/quadrature/gauss-rule
         "../../support/checks.rkt")

(define (integral n f)
  (define-values (nodes weights) (gauss-legendre-rule n))
  (for/sum ([x (in-flvector nodes)] [w (in-flvector weights)]) (* w (f x))))

(test-case "polynomials of degree 2n - 1 are integrated exactly, and the next is not"
  (for ([n (in-range 1 12)])
    (for ([k (in-range 0 (* 2 n))])
      (check-= (integral n (lambda (x) (expt x k))) (if (even? k) (/ 2.0 (+ k 1)) 0.0) 1e-14
               (format "n = ~a, degree ~a" n k)))
    (define k (* 2 n))
    (check-true (> (abs (- (integral n (lambda (x) (expt x k))) (/ 2.0 (+ k 1)))) 1e-8)
                (format "n = ~a, degree ~a" n k))))

(test-case "three nodes are those of the books"
  (define-values (nodes weights) (gauss-legendre-rule 3))
  (check-= (flvector-ref nodes 2) (sqrt 3/5) 1e-15)
  (check-= (flvector-ref weights 1) 8/9 1e-15))

(test-case "many nodes"
  (check-= (integral 400 cos) (* 2 (sin 1)) 1e-14))
