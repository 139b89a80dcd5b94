#lang racket/base
;; Of two masses far apart, and of a narrow peak on a level, an integral saw one without a word.
;; The place of a peak is part of its formula.

(require mechanics "../support/checks.rkt")

(define pi (acos -1.0))
(define ((peak c width) x) (exp (- (square (/ (- x c) width)))))
(define ((bump c width) x) (/ (/ width pi) (+ (square (- x c)) (square width))))
(define (mass width) (* width (sqrt pi)))

(define-check (check-integral f low high expected)
  (define found (definite-integral f low high))
  (unless (<= (abs (- found expected)) (* 1e-9 (max 1e-5 (abs expected))))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "masses far apart, to infinity"
  (for ([c '(100 -100 1234.5)])
    (check-integral (lambda (x) (+ ((peak 0 1) x) ((peak c 1) x))) -inf.0 +inf.0 (* 2 (mass 1)))
    (check-integral (lambda (x) (+ ((peak 0 1) x) ((bump c 1e-3) x))) -inf.0 +inf.0
                    (+ 1 (mass 1))))
  (check-integral (lambda (x) (+ ((peak 0 1) x) ((peak 1e6 1) x))) -inf.0 +inf.0 (* 2 (mass 1)))
  (check-exn #rx"^definite-integral: the integral was not found to the tolerance asked"
             (lambda () (definite-integral (lambda (x) (+ ((peak 0 1) x) ((bump 1e6 1e-3) x)))
                                           -inf.0 +inf.0)))
  (check-integral (lambda (x) (+ (exp (- x)) ((peak 300 1) x))) 0 +inf.0 (+ 1 (mass 1))))

(test-case "a narrow peak, alone and on a level"
  (for ([c '(0.3712345 -7.77 9.9999)])
    (check-integral (peak c 1e-5) -10 10 (mass 1e-5))
    (check-integral (lambda (x) (+ 1 ((peak c 1e-5) x))) -10 10 (+ 20 (mass 1e-5)))
    (check-integral (lambda (x) (+ 1 (* (square (- x c)) 1e10 ((peak c 1e-5) x)))) -10 10
                    (+ 20 (* 1/2 (mass 1e-5))))))

(test-case "at the zeros of a quadratic, and where it is least"
  (check-integral (lambda (x) (exp (* -1e8 (square (- (square x) 3))))) 0 5
                  (* 1e-4 (sqrt pi) (/ 1 (* 2 (sqrt 3)))))
  (check-integral (lambda (x) (+ 1 (exp (* -1e8 (+ (square x) (* -5 x) 25/4))))) 0 10
                  (+ 10 (mass 1e-4))))
