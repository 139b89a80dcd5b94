#lang racket/base
;; The floor of 1000 (10¹³ π - 31415926535897) was 929, by flonums; it is 932.

(require mechanics "../support/checks.rkt")

(define rest-of-pi (* 1000 (- (* (expt 10 13) ':pi) 31415926535897)))
(define rest-of-root (* 1000 (- (* (expt 10 12) (sqrt ':pi)) 1772453850905)))

(test-case "constants are rounded by their values, not by those of flonums"
  (check-equal? (floor rest-of-pi) 932)
  (check-equal? (ceiling rest-of-pi) 933)
  (check-equal? (round (- rest-of-pi)) -932)
  (check-equal? (floor rest-of-root) 516)
  (check-equal? (floor (* (expt 10 30) ':pi)) 3141592653589793238462643383279)
  (check-equal? (truncate (* -2 ':pi)) -6))

(test-case "a relative: constants that a flonum cannot tell from a jump"
  (check-equal? (floor (+ 1 (/ ':pi (expt 10 20)))) 1)
  (check-equal? (ceiling (+ 1 (/ ':pi (expt 10 20)))) 2))
