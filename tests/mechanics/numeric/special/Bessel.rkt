#lang racket/base
;; Bessel functions: values of tables, the recurrence, and what is tiny.

(require mechanics/value/Bessel-functions "../../support/checks.rkt")

(define (check-ratio value expected)
  (check-= (/ value expected) 1 1e-13))

(test-case "values of tables (Abramowitz and Stegun, 9.1 and 9.4)"
  (check-equal? (Bessel-J 0 0.0) 1.0)
  (check-equal? (Bessel-J 3 0.0) 0.0)
  (check-= (Bessel-J 0 1.0) 0.7651976865579666 1e-15)
  (check-= (Bessel-J 1 1.0) 0.4400505857449335 1e-15)
  (check-= (Bessel-J 0 2.404825557695773) 0.0 1e-15)
  (check-= (Bessel-J 2 10.0) 0.2546303136851206 1e-15)
  (check-= (Bessel-J 0 100.0) 0.01998585030422312 1e-15))

(test-case "tiny values keep their digits"
  (check-ratio (Bessel-J 10 0.1) 2.6905328954342155e-20)
  (check-ratio (Bessel-J 3 1e-9) (/ 1e-27 48))
  (check-ratio (Bessel-J 1 1e-200) 5e-201)
  (check-ratio (Bessel-J 50 1.0) 2.906004948173273e-80))

(test-case "the recurrence holds, at orders below the argument and above it"
  (for* ([n '(1 2 7 40)] [x '(0.3 5.0 38.0 1000.0)])
    (define sum (+ (Bessel-J (- n 1) x) (Bessel-J (+ n 1) x)))
    (check-= sum (* (/ (* 2 n) x) (Bessel-J n x)) (* 1e-12 (max (abs sum) 1e-3)))))

(test-case "the squares add up to 1"
  (for ([x '(0.5 7.0 50.0)])
    (define (square y) (* y y))
    (check-= (+ (square (Bessel-J 0 x))
                (* 2 (for/sum ([n (in-range 1 120)]) (square (Bessel-J n x)))))
             1 1e-13)))
