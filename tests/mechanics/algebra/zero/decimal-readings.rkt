#lang racket/base
;; Readings of decimals, and decimals that are not read.

(require (only-in math/flonum epsilon.0 flstep)
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/zero/decimal-readings
         mechanics/algebra/zero/zero-test
         "../../support/checks.rkt")

(define (read-as x) (let ([e (read-decimal x)]) (and e (expression->datum e))))

(test-case "decimals are fractions, roots, solutions of quadratic equations, multiples of π and e"
  (for ([entry (in-list '((0.30000000000000004 3/10) (1.4142135623730951 (sqrt 2)) (-0.5 -1/2)
                          (6.674e-11 3337/50000000000000)
                          (1.618033988749895 (* 1/2 (+ 1 (sqrt 5))))
                          (1.0471975511965976 (* 1/3 :pi))
                          (1.3591409142295225 (* 1/2 (exp 1)))))])
    (check-equal? (read-as (car entry)) (cadr entry)))
  (check-equal? (read-as 1.41421356) #f)
  (check-equal? (read-as 1.3579246801) #f)
  (check-equal? (read-as 1.3579246801000003) #f))

(define (different? . xs) (all-different? (read-decimals xs)))

(test-case "decimals of different size are not one number"
  (check-false (different? 0.3 0.30000000000000004))
  (check-false (different? 2.0 1.5 -2.0000000000000004))
  (check-true (different? 0.3 -0.3 0.1 1.4142135623730951)))

;; x, and the next flonums above it
(define (neighbours x) (for/list ([k (in-range 9)]) (flstep x k)))

(test-case "a decimal is read as what it is near to, and what is rational as a fraction"
  (for* ([x (in-list (list 0.1 0.25 2/3 1.5 7.0 (sqrt 2) (/ (+ 1 (sqrt 5)) 2)))]
         [y (in-list (neighbours (exact->inexact x)))]
         [e (in-value (read-decimal y))]
         #:when e)
    (define value (real-value e void))
    (check-true (<= (abs (- y value)) (* 4 epsilon.0 value)) (format "~a as ~a" y e))
    (check-equal? (rational? e) (rational? (simplify-expression e)) (format "~a" y))))

(define (status d) (zero-test-status (zero-test (datum->expression d))))

(test-case "no proof takes decimals that were written differently for one"
  (check-equal? (status '(- (* 2.0000000000000004 x) (* 2.0 x))) 'undecided)
  (check-equal? (status '(+ (* 0.1 x) (* -0.10000000000000002 x))) 'undecided)
  (check-equal? (status '(- (* 0.1 x) (* 0.1000000000000001 x))) 'undecided)
  (check-equal? (status '(- (cos (* 0.3 x)) (cos (* 0.30000000000000004 x)))) 'undecided))

(test-case "but a decimal may be the exact number beside it"
  (check-equal? (status '(- (* 2.0000000000000004 x) (* 2 x))) 'proved)
  (check-equal? (status '(- (* 0.5 x) (/ x 2))) 'proved)
  (check-equal? (status '(- (cos (* 1.4142135623730951 x)) (cos (* (sqrt 2) x)))) 'proved))

;; A sum of n terms that vanishes only if each of its decimals is read.
(define (sum-of n)
  (cons '+ (for/list ([k (in-range 1 (+ n 1))])
             `(- (cos (* ,(/ k 128.0) x)) (cos (* ,(/ k 128) x))))))

(test-case "where there are many decimals none is read"
  (check-equal? (status (sum-of 24)) 'proved)
  (define z (zero-test (datum->expression (sum-of 25))))
  (check-equal? (zero-test-status z) 'undecided)
  (check-equal? (length (zero-test-decimals z)) 25)
  (check-false (ormap reading-expression (zero-test-decimals z))))
