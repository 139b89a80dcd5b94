#lang racket/base
;; The sign of a root was asked of the factor that is kept, x - 1, where the root is of its
;; opposite: √(1/√(1-x)) came out negative, and a statement and its opposite were proved.
;; Signs assumed were those of such factors at no point in particular, so that they held at
;; no real point, or contradicted what was declared or one another; the alphabet decided.

(require mechanics "../support/checks.rkt")

(define ((acceleration L) q) ((Lagrangian->acceleration L) (up 0 q 0.0)))

(test-case "a root of a reciprocal root is positive, and its opposite is not proved"
  (define e (sqrt (/ 1 (sqrt (- 1 'x)))))
  (check-equal? (expression (simplify e)) '(/ 1 (expt (- 1 x) 1/4)))
  (check-true (proved? (prove-zero (- e (/ 1 (expt (- 1 'x) 1/4))))))
  (check-false (proved? (prove-zero (+ e (/ 1 (expt (- 1 'x) 1/4))))))
  (define (L s) (- (* 1/2 (square (velocity s))) (sqrt (/ 1 (sqrt (- 2 (coordinate s)))))))
  (check-= (substitute (simplify ((Lagrangian->acceleration L) (up 't 'q 'v))) 'q 1.0)
           ((acceleration L) 1.0) 1e-15)
  ;; a relative: cube roots, and a factor that is kept with the other sign
  (check-true (proved? (prove-zero (- (expt (/ 1 (expt (- 3 (* 2 'x)) 1/3)) 1/2)
                                      (/ 1 (expt (- 3 (* 2 'x)) 1/6)))))))

(test-case "what real numbers decide is not assumed"
  (for ([u (list (- 2 (cos 'x)) (- 2 (atan 'x)) (- 2 (* (sin 'x) (cos 'y))))])
    (define v (prove-zero (- (sqrt (square u)) u)))
    (check-true (proved? v))
    (check-equal? (verdict-assumptions v) '()))
  (define (L s) (- (* 1/2 (square (velocity s))) (sqrt (square (- (cos (coordinate s)) 2)))))
  (check-equal? (expression (simplify (((Lagrange-equations L) (literal-function 'q)) 't)))
                '(+ (((expt D 2) q) t) (sin (q t)))))

(test-case "what is assumed holds somewhere"
  (for ([u (list (- 'x (exp 'x)) (- (* 'x (exp (- 'x))) 1))])
    (check-true (proved? (prove-zero (+ (sqrt (square u)) u))))
    (check-false (proved? (prove-zero (- (sqrt (square u)) u))))))

(test-case "what is assumed agrees with what was declared"
  (define-syntax-rule (check-opposite relation u)
    (begin
      (check-true (assuming ('relation) (proved? (prove-zero (+ (sqrt (square u)) u)))))
      (check-false (assuming ('relation) (proved? (prove-zero (- (sqrt (square u)) u)))))))
  (check-opposite (< (* x y) 0) (* 'x 'y))
  (check-opposite (< (/ x y) 0) (/ 'x 'y))
  (check-opposite (< 0 x 1) (log 'x))
  (check-opposite (< x 0) (- (exp 'x) 1))
  (check-opposite (< x 0) (asinh 'x))
  (check-opposite (< (square e) 1) (- 'e 1))
  (check-opposite (< a b c) (- 'a 'c)))

(test-case "a product of known sign is told without its factors"
  (check-equal? (assuming ('(< (* x y) 0))
                  (verdict-assumptions (prove-zero (+ (sqrt (square (* 'x 'y))) (* 'x 'y)))))
                '((< (* x y) 0))))

(test-case "where a root or a logarithm has a value nothing is assumed"
  (for ([e (list (- (/ 1 (sqrt 'x)) (sqrt (/ 1 'x)))
                 (- (log (expt 'x 3)) (* 3 (log 'x)))
                 (- (abs (sqrt 'x)) (sqrt 'x))
                 (- (log (* (- 'x 'y) 'z)) (log (- 'x 'y)) (log 'z))
                 (- (log (* (- 'y 'x) 'z)) (log (- 'y 'x)) (log 'z))
                 (- (acos (sin (asin 'x))) (acos 'x))
                 (* (- (sqrt (square (- 1 'x))) (- 1 'x)) (asin 'x)))])
    (define v (prove-zero e))
    (check-true (proved? v) (format "~a" e))
    (check-equal? (verdict-assumptions v) '()))
  (check-false (assuming ('(< x 0)) (refuted? (prove-zero (- (/ 1 (sqrt 'x)) (sqrt (/ 1 'x))))))))

(test-case "what is nowhere defined is undecided"
  (define z (- (square (sin 'x)) (- 1 (square (cos 'x)))))
  (define below (- -1 (square 'y)))
  (for ([e (list (* z (/ 1 z)) (- (/ z z) 1) (- (/ z z) 2)
                 (- (sqrt below) (/ below (sqrt below)))
                 (- (log (exp (log below))) (log below)))])
    (check-true (undecided? (prove-zero e)) (format "~a" e))))
