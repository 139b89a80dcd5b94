#lang racket/base
;; π was compared with other constants by its flonum: it was not greater than its first forty
;; digits, and constants that cancel were ordered by what rounding left of them.

(require mechanics "../support/checks.rkt" "../support/messages.rkt")

;; π lies between these.
(define below 3141592653589793238462643383279502884197/1000000000000000000000000000000000000000)
(define above (+ below 1/1000000000000000000000000000000000000000))

(test-case "an order of exact constants is exact"
  (check-true (< below ':pi above))
  (check-true (> above ':pi below))
  (check-false (< ':pi below))
  (check-false (<= ':pi below))
  (check-true (<= (* 2 below) (* 2 ':pi)))
  (check-true (< 177245385090551602729816748334114518/100000000000000000000000000000000000
                 (sqrt ':pi)
                 177245385090551602729816748334114519/100000000000000000000000000000000000))
  (check-true (< (square below) (square ':pi) (square above)))
  (check-true (positive? (- ':pi below)))
  (check-true (negative? (- ':pi above)))
  (check-true (negative? (- (* 10000000000000 ':pi) 31415926535898)))
  (check-equal? (max below ':pi above) above)
  (check-equal? (min ':pi above) ':pi))

(test-case "a flonum stands for its exact value, as in Racket's own comparisons"
  (check-true (< 3.141592653589793 ':pi))
  (check-false (<= ':pi 3.141592653589793))
  (check-true (< ':pi +inf.0))
  (check-false (or (< ':pi +nan.0) (>= ':pi +nan.0)))
  (check-true (> ':pi (bigfloat "3.1415926535897932384626433832795028841971" 100))))

(test-case "equal constants are neither less nor greater"
  (define a (* ':pi (+ 1 ':pi)))
  (define b (+ ':pi (square ':pi)))
  (check-false (or (< a b) (> a b)))
  (check-true (and (<= a b) (>= a b)))
  (check-false (or (positive? (- a b)) (negative? (- a b)))))

(test-case "a constant without a real value has no order"
  (check-exn #rx"^<: an expression that is not a number has no order"
             (lambda () (< (sqrt (- 1 ':pi)) 1))))

;; cos(π/7) − cos(2π/7) + cos(3π/7) = 1/2, which no bounds tell.
(test-case "an order that more and more digits do not tell is refused by the one that asks"
  (define (c k) (cos (* k 1/7 ':pi)))
  (define sum (+ (c 1) (- (c 2)) (c 3)))
  (for ([compare (list < >=)] [name '("<" ">=")])
    (check-message
     (string-append name ": two constants are too close to be told apart by their decimals")
     (compare sum 1/2))))
