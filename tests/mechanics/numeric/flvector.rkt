#lang racket/base
;; Flvectors as points and directions.

(require racket/flonum
         mechanics/numeric/flvector
         "../support/checks.rkt")

(define v (flvector 3.0 -4.0 12.0))
(define w (flvector 1.0 2.0 -2.0))

(test-case "points and directions"
  (check-equal? (flvector->list v) '(3.0 -4.0 12.0))
  (check-equal? (unit-flvector 1 3) (flvector 0.0 1.0 0.0))
  (check-equal? (flvector-map abs v) (flvector 3.0 4.0 12.0))
  (check-equal? (flvector-map * v w) (flvector 3.0 -8.0 -24.0))
  (check-equal? (flvector-scaled 2.0 v) (flvector 6.0 -8.0 24.0))
  (check-equal? (along v 2.0 w) (flvector 5.0 0.0 8.0))
  (check-equal? (difference v w) (flvector 2.0 -6.0 14.0)))

(test-case "lengths and distances"
  (check-equal? (dot v w) -29.0)
  (check-equal? (norm v) 13.0)
  (check-equal? (greatest (flvector 3.0 -4.0)) 4.0)
  (check-equal? (greatest (flvector 0.25 -0.5)) 0.5)
  (check-equal? (distance (flvector 0.25 0.5) (flvector 0.5 0.5)) 0.25)
  (check-equal? (distance v w) 14.0)
  (check-equal? (distance w v) 14.0)
  (check-true (short? (flvector 0.4 -0.5) (flvector 3.0 -4.0) 0.1))
  (check-false (short? (flvector 0.4 -0.51) (flvector 3.0 -4.0) 0.1))
  (check-false (short? (flvector 0.41 0.0) (flvector 3.0 -4.0) 0.1)))

(test-case "which are finite"
  (check-true (flvector-finite? v))
  (check-true (flvector-finite? (flvector)))
  (for* ([bad (in-list '(+inf.0 -inf.0 +nan.0))] [i (in-range 3)])
    (define u (flvector-copy v))
    (flvector-set! u i bad)
    (check-false (flvector-finite? u))))

(test-case "in place"
  (define u (flvector 1.0 2.0 3.0))
  (flvector-swap! u 0 2)
  (check-equal? u (flvector 3.0 2.0 1.0))
  (flvector-copy! u (flvector 7.0 8.0))
  (check-equal? u (flvector 7.0 8.0 1.0))
  (flvector-copy! u (flvector 4.0 5.0 6.0 9.0))
  (check-equal? u (flvector 4.0 5.0 6.0)))
