#lang racket/base
;; Numbers with so many digits.

(require mechanics/algebra/expression/exact-numbers
         "../../support/checks.rkt")

(test-case "digits are counted from the first that is not 0"
  (check-equal? (map (lambda (x) (to-digits x 3)) '(3.14159 -0.00271828 299792458 2/3 9.999 1e-300))
                '(3.14 -0.00272 300000000.0 0.667 10.0 1e-300)))

(test-case "where flonums went in, a number is one, unless it is whole"
  (for ([x+shown '((1/2 . 0.5) (3 . 3) (-7/4 . -1.75))])
    (check-equal? (present-number (car x+shown) #t) (cdr x+shown))
    (check-equal? (present-number (car x+shown) #f) (car x+shown))))

(test-case "what has no digits stays as it is"
  (for ([x '(0 0.0 -0.0 +inf.0 -inf.0 +nan.0)]) (check-equal? (to-digits x 3) x)))
