#lang racket/base
;; e^(a + b) was not e^a e^b where a had a sum in its denominator: over the common
;; denominator b had other terms than by itself.  A difference equal to 0 was printed
;; as (- 1 1), refuted, or an internal error.

(require mechanics "../support/checks.rkt")

(define (proved-zero? e) (proved? (prove-zero e)))

(define (sine-of-sum a b) (+ (* (sin a) (cos b)) (* (cos a) (sin b))))
(define (cosine-of-sum a b) (- (* (cos a) (cos b)) (* (sin a) (sin b))))

(define pairs
  (list (list 'z (/ 'x (+ 1 'y)))
        (list 'y (/ 1 (+ 'x 'z)))
        (list (square 'x) (/ 'x (+ 1 'y)))
        (list (/ 1 (+ 1 'x)) (/ 1 (+ 1 'y)))
        (list (/ 'x (* 'y (+ 1 'x))) (/ 'y (square (- 'x 'y))))
        (list (/ 1 (expt (+ 1 'x) 9)) (/ 1 (expt (+ 1 'y) 9)))
        (list (/ 'x (+ 1 (sqrt 'y))) (/ 1 (+ 'x (sin 'z))))
        (list (/ ((literal-function 'f) 't) (+ 1 ((literal-function 'g) 't))) (* 'w 't))))

(test-case "exponentials of sums are products"
  (for ([pair (in-list pairs)])
    (define-values (a b) (apply values pair))
    (check-true (proved-zero? (- (exp (+ a b)) (* (exp a) (exp b)))))
    (check-equal? (simplify (- (exp (+ a b)) (* (exp a) (exp b)))) 0)
    (check-true (proved-zero? (- (/ (exp a) (exp b)) (exp (- a b)))))))

(test-case "addition theorems"
  (for ([pair (in-list pairs)])
    (define-values (a b) (apply values pair))
    (check-true (proved-zero? (- (sin (+ a b)) (sine-of-sum a b))))
    (check-true (proved-zero? (- (/ 1 (cos (+ a b))) (/ 1 (cosine-of-sum a b)))))))

(test-case "a statement that is off by little is refuted"
  (define a (/ 'x (+ 1 'y)))
  (check-true (refuted? (prove-zero (- (exp (+ a 'z)) (* (exp a) (exp 'x)))))))

(test-case "inverse functions and logarithms are found beside fractions"
  (define a (/ 'x (+ 1 'y)))
  (check-true (proved-zero? (- (exp (+ a (* 2 (log 'z)))) (* (square 'z) (exp a)))))
  (check-true (proved-zero? (- (sin (+ a (asin 'z)))
                               (sine-of-sum a (asin 'z))))))

(test-case "angles that stand alone are shown as they were"
  (check-equal? (format "~a" (simplify (sin (+ (/ 1 (+ 'x 'z)) 'y)))) "(sin (+ y (/ 1 (+ x z))))")
  (check-equal? (format "~a" (simplify (exp (+ 'z (/ 'x (+ 1 'y))))))
                "(exp (+ z (/ x (+ 1 y))))"))

(test-case "determinants and linear systems with such exponentials"
  (define a (/ 'x (+ 1 'y)))
  (define M (matrix-by-rows (list (exp (+ a 'z)) (exp 'z)) (list (exp a) 1)))
  (check-equal? (simplify (determinant M)) 0))
