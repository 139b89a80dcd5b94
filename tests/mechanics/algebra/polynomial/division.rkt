#lang racket/base
;; Exact division.

(require mechanics/algebra/polynomial/polynomial
         "../../support/checks.rkt" "../../support/random.rkt"
         "../../support/random/polynomial.rkt")

(for ([n '(1 3 50)])
  (test-case (format "dividing a product gives the factor back, in ~a variables" n)
    (define R (make-ring n 20))
    (with-seeds 40
      (define p (random-polynomial R #:terms 12 #:degree 5))
      (define q (random-polynomial R #:terms 12 #:degree 5))
      (unless (poly-zero? q)
        (check-equal? (poly-divide R (poly* R p q) q) p)))))

(test-case "what does not divide gives #f"
  (define R (make-ring 3 20))
  (define x (poly-variable R 0))
  (define y (poly-variable R 1))
  (define one (poly-constant R 1))
  (check-false (poly-divide R x y))
  (check-false (poly-divide R x (poly+ R x one)))
  (check-false (poly-divide R one x))
  (check-false (poly-divide R (poly+ R (poly* R x y) one) y))
  (with-seeds 40
    (define p (random-polynomial R))
    (define q (random-polynomial R))
    (unless (poly-constant? q)
      (check-false (poly-divide R (poly+ R (poly* R p q) one) q)))))

(test-case "zero is divided by everything and divides nothing"
  (define R (make-ring 2 5))
  (define zero (poly-constant R 0))
  (check-equal? (poly-divide R zero (poly-variable R 0)) zero)
  (check-equal? (poly-divide R zero (poly+ R (poly-variable R 0) (poly-constant R 1))) zero)
  (check-exn #rx"poly-divide: contract violation.*nonzero"
             (lambda () (poly-divide R (poly-variable R 0) zero))))

(test-case "division is over the rationals"
  (define R (make-ring 1 5))
  (define x (poly-variable R 0))
  (check-equal? (poly-divide R x (poly-scale R 3 x)) (poly-constant R 1/3))
  (define p (poly+ R (poly-scale R 2 x) (poly-constant R 1)))
  (check-equal? (poly-divide R p (poly-scale R 5 p)) (poly-constant R 1/5)))
