#lang racket/base
;; Derivatives of integrals within integrals, with jumps that leave the inner range; jumps that
;; no sample sees; and derivatives by symbols that are in the integrand.

(require mechanics "../support/checks.rkt")

(define (I f) (definite-integral f 0 1))
(define ((twice f) a) (I (lambda (x) (I (lambda (y) (f x y a))))))
(define-syntax-rule (indicator test) (if test 1 0))

(define-check (check-slope F a expected tolerance)
  (define found ((D F) a))
  (unless (< (abs (- found expected)) tolerance)
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "jumps of the inner integrand that end where the outer variable has some value"
  (check-slope (twice (lambda (x y a) (indicator (< y (* a x))))) 0.5 0.5 1e-9)
  (define triangle (twice (lambda (x y a) (indicator (< (+ x y) a)))))        ; a²/2
  (check-slope triangle 0.7 0.7 1e-9)
  (check-= (((square D) triangle) 0.7) 1.0 1e-8)
  (check-slope (twice (lambda (x y a) (indicator (< (+ (square x) (square y)) a))))
               0.5 (/ pi 4) 1e-8)
  (check-slope (twice (lambda (x y a) (abs (- (* x y) a)))) 0.3 (- (* 0.6 (- 1 (log 0.3))) 1)
               1e-8))

(test-case "a test on the outer variable within the inner integral"
  (check-slope (twice (lambda (x y a) (if (< x a) y (* 2 y)))) 0.3 -0.5 1e-9))

(test-case "two jumps closer to each other than samples are"
  (check-slope (lambda (a) (I (lambda (x) (indicator (< (abs (- x 0.5003)) a))))) 0.001 2.0 1e-8)
  (check-slope (lambda (a) (I (lambda (x) (indicator (< (square (- x 0.5)) a))))) 1e-5
               (/ 1 (sqrt 1e-5)) 1e-5))

(test-case "jumps that are told by an equation alone"
  ;; x e^x = a, at x = W(a)
  (check-slope (lambda (a) (I (lambda (x) (indicator (< (* x (exp x)) a)))))
               0.5 ((D Lambert-W) 0.5) 1e-8)
  (define (root a) (find-root (lambda (y) (- (cube y) a)) 1))
  (check-slope (lambda (a) (I (lambda (x) (if (< x (root a)) x 0))))
               0.2 (* 1/3 (expt 0.2 -1/3)) 1e-8))

(define-check (check-same found expected)
  (unless (proved? (prove-zero (- found expected)))
    (with-check-info (['found found]) (fail-check))))

(test-case "by a symbol that is in the integrand"
  (define (E a) (I (lambda (x) (exp (* a x)))))                               ; (e^a − 1)/a
  (define closed (lambda (a) (/ (- (exp a) 1) a)))
  (check-same ((D E) 'b) ((D closed) 'b))
  (check-same (((square D) E) 'b) (((square D) closed) 'b))
  (check-same ((D (D E)) 'b) ((D (D closed)) 'b))
  (check-same ((D (lambda (a) (definite-integral (lambda (x) (sin (* a x))) 0 'c))) 'b)
              ((D (lambda (a) (/ (- 1 (cos (* a 'c))) a))) 'b))
  (check-same ((D (lambda (a) (definite-integral (lambda (x) (* a x)) 0 a))) 'b)
              (* 3/2 (square 'b)))
  (check-same ((D (lambda (b) (I (lambda (x) (* 'k x b))))) 2) (* 1/2 'k))
  (check-same (((partial 0) (lambda (a c) (I (lambda (x) (* c (cos (* a x))))))) 'b 'c)
              (((partial 0) (lambda (a c) (/ (* c (sin a)) a))) 'b 'c)))
