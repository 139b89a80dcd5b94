#lang racket/base
;; √(x²) was x along the whole of a path that passes 0; a pole between the ends was a condition in
;; the bound variable, or none; logarithms of negative numbers made formulas complex.

(require mechanics
         "../support/checks.rkt")

(define interrupted
  #rx"^definite-integral: the integrand has no integral between these ends, or none ")

(define-syntax-rule (check-refused message f low high)
  (check-exn message (lambda () (definite-integral f low high))))

(test-case "a pole between the ends is no condition"
  (check-refused interrupted (lambda (x) (* 'a (tan x))) 0 2)
  (check-refused interrupted (lambda (x) (/ 'a (square x))) -1 1)
  (check-refused interrupted (lambda (x) (/ (* 'a (cos x)) (square (sin x)))) -1 1)
  (check-refused interrupted (lambda (x) (* 'c (sqrt x))) -1 1))

;; formula, conditions, and values of parameters that satisfy them
(define-check (check-conditions f low high expected places)
  (unless (equal? (integral-conditions f low high) expected)
    (with-check-info (['found (integral-conditions f low high)]) (fail-check)))
  (define formula (definite-integral f low high))
  (for ([place (in-list places)])
    (define (put e)
      (for/fold ([e e]) ([p (in-list place)]) (substitute e (car p) (cdr p))))
    (define (number x) (exact->inexact (simplify (put x))))
    (define numbers
      (definite-integral (lambda (x) (number (f x))) (number low) (number high)))
    (define found (number formula))
    (unless (and (real? found) (< (abs (- numbers found)) 1e-8))
      (with-check-info (['place place] ['formula formula] ['found found] ['number numbers])
        (fail-check)))))

(test-case "the root of a square has one sign only where its argument has"
  (define places '(((a . 2)) ((a . 1/3)) ((a . -1/2))))
  (check-conditions (lambda (x) (sqrt (square x))) (- 'a) 'a '() places)
  (check-conditions (lambda (x) (sqrt (square (- x 'a)))) 0 1 '() places)
  (check-conditions (lambda (t) (* 'a (sqrt (+ (square t) (expt t 4))))) -1 1 '() places)
  (check-conditions (lambda (x) (* 'k (abs (- x 'a)))) 0 1 '()
                    '(((k . 2) (a . 1/3)) ((k . 1) (a . -1)))))

(test-case "conditions speak of ends and parameters, and where they hold the formula is real"
  (check-conditions (lambda (x) (/ 1 (- (square x) (square 'b)))) 0 1
                    '((> (- (expt b 2) b) 0) (> (+ (expt b 2) b) 0) (> (abs b) 0))
                    '(((b . 2)) ((b . -2)) ((b . 11/10))))
  (check-conditions (lambda (x) (/ 1 (* (- x 'b) (- x 'c)))) 0 1
                    '((> (- (expt c 2) c) 0) (> (- (expt b 2) b) 0) (> (abs (- b c)) 0))
                    '(((b . -1) (c . 2)) ((b . 3) (c . 2)) ((b . -3) (c . -1))))
  (check-conditions (lambda (x) (* 'a (tan x))) 0 'b
                    '((> (- :pi (abs b)) 0) (> (cos b) 0))
                    '(((a . 2) (b . 3/2)) ((a . 2) (b . -3/2))))
  (check-conditions (lambda (x) (/ x (- (square x) 'b))) 0 1 '((> (- (expt b 2) b) 0))
                    '(((b . 2)) ((b . -2))))
  (check-conditions (lambda (x) (/ (* 'a x) (expt (+ (square x) (square 'h)) 3/2))) -1 'b
                    '((> (abs h) 0))
                    '(((a . 1) (h . -2) (b . 3)) ((a . 1) (h . 1/2) (b . -1/2)))))

(test-case "what is integrable in parts of the line keeps its formula on each"
  (check-conditions (lambda (x) (/ 1 (+ x 'b))) 0 1 '((> (+ (expt b 2) b) 0))
                    '(((b . 1)) ((b . -3))))
  (check-conditions (lambda (x) (/ 1 (sqrt (- (square x) 1)))) 'a 'b '()
                    '(((a . 2) (b . 3)) ((a . -3) (b . -2))))
  (check-conditions (lambda (x) (/ (log x) x)) 'a 'b '((> (* a b) 0))
                    '(((a . 1/2) (b . 3)))))
