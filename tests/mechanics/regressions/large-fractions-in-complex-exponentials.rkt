#lang racket/base
;; e^(i(10000 + 1/3)) is e^(10000 i) e^(i/3): the rounding of 30001/3 to a flonum was left out of
;; the error, and the identity refuted.

(require mechanics/algebra/expression/read
         mechanics/algebra/zero/zero-test
         "../support/checks.rkt")

(define (status d) (zero-test-status (zero-test (datum->expression d))))

(define third '(asin (sin 1/3)))        ; of which the algebra does not know that it is 1/3

(test-case "the sum of a large fraction is not refuted"
  (for ([d `((- (exp (* +i 30001/3)) (* (exp (* +i 10000)) (exp (* +i ,third))))
             (- (exp (* +i (+ x 1000000/3))) (* (exp (* +i (+ x 333333))) (exp (* +i ,third)))))])
    (check-eq? (status d) 'undecided (format "~s" d))))

(test-case "but a difference that is seen is"
  (check-eq? (status `(- (exp (* +i 30001/3)) (* (exp (* +i 10001)) (exp (* +i ,third)))))
             'refuted))
