#lang racket/base
;; Intervals hold the values of functions within them.

(require racket/math
         mechanics/algebra/assumption/interval
         mechanics/algebra/assumption/polynomial-range
         mechanics/algebra/assumption/range
         (only-in mechanics/algebra/expression/numeric-functions erf)
         mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (ends r) (list (interval-low r) (interval-high r)))
(define (of name low high) (ends (interval-of-operation name (interval low high))))

(define (inside? y r)
  (define slack (* 1e-12 (+ 1 (abs y))))
  (and (<= (interval-low r) (+ y slack)) (<= (- y slack) (interval-high r))))

(test-case "exact ends stay exact"
  (check-equal? (of 'exp 0 +inf.0) '(1 +inf.0))
  (check-equal? (of 'log 1 +inf.0) '(0 +inf.0))
  (check-equal? (of 'sqrt 1/4 4) '(1/2 2))
  (check-equal? (car (of 'sin 0 1)) 0)
  (check-equal? (of 'abs -2 -1) '(1 2)))

(test-case "an argument between two flonums is seen from both sides"
  ;; e^x = e^y (1 - (y - x) + ...), where y is the flonum beside x
  (for ([n (in-range 7001 7009)])
    (define x (/ n 10))
    (define y (exact->inexact x))
    (define value (* (inexact->exact (exp y)) (- 1 (- (inexact->exact y) x))))
    (define ends-there (of 'exp x x))
    (check-true (< (car ends-there) value (cadr ends-there)) (format "~a" x))))

(test-case "quotients and powers of intervals, with exact ends"
  (define (quotient low high) (ends (interval-quotient (interval 1 2) (interval low high))))
  (check-equal? (quotient 1/4 1/2) '(2 8))
  (check-equal? (quotient -1/2 -1/4) '(-8 -2))
  (check-equal? (quotient 1/2 +inf.0) '(0 4))
  (for ([around '((-1 1) (0 1) (-1 0))])
    (check-equal? (apply quotient around) '(-inf.0 +inf.0)))
  (define (power low high n) (ends (interval-power (interval low high) n)))
  (check-equal? (power 1/2 2 -2) '(1/4 4))
  (check-equal? (power -2 -1 -1) '(-1 -1/2))
  (check-equal? (power -1 2 2) '(0 4))
  (check-equal? (power -1 2 3) '(-1 8)))

(test-case "a sine reaches 1 where it does"
  (check-equal? (cadr (of 'sin 1 2)) 1)
  (check-true (< (cadr (of 'sin 2 3)) 91/100))
  (check-equal? (of 'cos -1000 0) '(-1 1))
  (check-equal? (of 'sin 0 +inf.0) '(-1 1)))

(test-case "values at random points are inside"
  (define functions (hasheq 'exp exp 'sqrt sqrt 'log log 'sinh sinh 'tanh tanh 'atan atan 'erf erf
                            'cosh cosh 'sin sin 'cos cos 'asin asin 'acos acos))
  (define bounds (hasheq 'sqrt '(0 +inf.0) 'log '(1e-300 +inf.0) 'asin '(-1 1) 'acos '(-1 1)))
  (parameterize ([current-pseudo-random-generator (make-pseudo-random-generator)])
    (random-seed 11)
    (for* ([(name f) (in-hash functions)] [_ (in-range 500)])
      (define a (/ (- (random 400) 200) (+ 1 (random 90))))
      (define b (+ a (/ (random 300) (+ 1 (random 90)))))
      (define x (+ a (* (random) (- b a))))
      (when (apply <= (let ([b (hash-ref bounds name '(-inf.0 +inf.0))]) (list (car b) x (cadr b))))
        (check-true (inside? (f x) (interval-of-operation name (interval a b)))
                    (format "~a on ~a ~a at ~a" name a b x))))))

(test-case "numbers greater than all flonums are no infinities"
  (define huge (expt 10 400))
  (check-true (<= (car (of 'log huge +inf.0)) 921))
  (check-true (<= 1 (car (of 'sqrt (+ huge 1) +inf.0)) (integer-sqrt (+ huge 1))))
  (check-true (>= (cadr (of 'sinh -inf.0 (- huge))) (- huge)))
  (check-equal? (cadr (of 'exp 0 huge)) +inf.0))

(test-case "a polynomial in one unknown knows that its terms are of one number"
  (define e (datum->expression '(+ (square x) (* -2 x) 2)))
  (define (places leaf) (interval 2 +inf.0))
  (check-equal? (ends (polynomial-range e places)) '(2 +inf.0))
  (check-equal? (ends (range-over e places)) '(-inf.0 +inf.0))
  (check-false (polynomial-range (datum->expression '(+ x y)) places)))
