#lang racket/base
;; e^(i(10000 + 1/3)) is e^(10000 i) e^(i/3): the rounding of 30001/3 to a flonum was left out of
;; the error, and the identity refuted.  So were others by the bound |sin'| ≤ 1, which holds for
;; real numbers alone.

(require mechanics/algebra/expression/read
         mechanics/algebra/zero/zero-test
         "../support/checks.rkt")

(define (status d) (zero-test-status (zero-test (datum->expression d))))

(define third '(asin (sin 1/3)))        ; of which the algebra does not know that it is 1/3

(test-case "the sum of a large fraction is not refuted"
  (for ([d `((- (exp (* +i 30001/3)) (* (exp (* +i 10000)) (exp (* +i ,third))))
             (- (exp (* +i (+ x 1000000/3))) (* (exp (* +i (+ x 333333))) (exp (* +i ,third)))))])
    (check-not-equal? (status d) 'refuted (format "~s" d))))

(test-case "nor are sines and tangents of complex numbers"
  (for ([d `((- (sin (* +i 394/3))
                (* +i 1/2 (- (* (exp 131) (exp ,third)) (/ 1 (* (exp 131) (exp ,third))))))
             (- (tanh (* +i (+ 11/7 1/330))) (tanh (* +i (+ 11/7 (* 1/110 ,third))))))])
    (check-not-equal? (status d) 'refuted (format "~s" d))))

(test-case "a number that no flonum holds is refuted as it was"
  (check-eq? (status `(- (exp (* +i (log ,(expt 10 400)))) 2)) 'refuted)
  (check-eq? (status `(- (* +i (log (+ x ,(expt 10 320)))) 2)) 'refuted))

(test-case "but a difference that is seen is"
  (check-eq? (status `(- (exp (* +i 30001/3)) (* (exp (* +i 10001)) (exp (* +i ,third)))))
             'refuted))
