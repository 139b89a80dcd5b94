#lang racket/base
;; The rule of signs, against numbers of all signs.

(require mechanics/algebra/assumption/signs
         "../../support/checks.rkt")

(define numbers '(-2 -1 -1/2 0 1/2 1 2))
(define sets (list 0 negative nonpositive zero nonzero positive nonnegative any-sign))

(define (of s) (filter (lambda (x) (signs-within? (number-signs x) s)) numbers))
(define (signs-of xs) (for/fold ([s 0]) ([x (in-list xs)]) (bitwise-ior s (number-signs x))))

(test-case "sets have the numbers of their names"
  (define (check-numbers s holds?) (check-equal? (of s) (filter holds? numbers)))
  (check-numbers negative negative?)
  (check-numbers nonpositive (lambda (x) (<= x 0)))
  (check-numbers zero zero?)
  (check-numbers positive positive?)
  (check-numbers nonnegative (lambda (x) (>= x 0)))
  (check-numbers nonzero (lambda (x) (not (zero? x))))
  (check-numbers any-sign values))

(test-case "a sign is decided where no two numbers have opposite ones"
  (for ([s (in-list sets)])
    (check-equal? (signs-decided? s)
                  (not (for*/or ([x (in-list (of s))] [y (in-list (of s))]) (< (* x y) 0))))))

(test-case "sums, products and powers have the signs of those of numbers, and no others"
  (for ([a (in-list sets)])
    (for ([b (in-list sets)])
      (define (all f) (signs-of (for*/list ([x (in-list (of a))] [y (in-list (of b))]) (f x y))))
      (check-equal? (signs-sum a b) (all +))
      (check-equal? (signs-product a b) (all *)))
    (for ([n (in-range -3 4)])
      (check-equal? (signs-power a n)
                    (signs-of (for/list ([x (in-list (of a))] #:unless (and (eqv? x 0) (< n 0)))
                                (expt x n)))
                    (format "~b to the power ~a" a n)))))

(test-case "a part may have the signs with which the whole comes out"
  (for* ([signs (in-list sets)] [others (in-list sets)])
    (define (with f)
      (signs-of (for*/list ([x (in-list numbers)] [y (in-list (of others))]
                            #:when (signs-within? (number-signs (f x y)) signs))
                  x)))
    (check-equal? (term-signs signs others) (with +))
    (check-equal? (factor-signs signs 3 others) (with (lambda (x y) (* (expt x 3) y))))))
