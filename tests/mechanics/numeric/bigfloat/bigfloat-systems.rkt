#lang racket/base
;; Linear systems in numbers of higher precision, put back into their equations.

(require math/bigfloat
         mechanics/numeric/bigfloat/bigfloat-systems
         "../../support/checks.rkt" "../../support/bigfloats.rkt" "../../support/skip.rkt")

(define (rows . lists) (for/vector ([row (in-list lists)]) (list->vector (map bf row))))

(skip-unless bigfloats? no-bigfloats
  (test-case "Hilbert's matrix of 12 rows, of which flonums lose all digits"
    (parameterize ([bf-precision 300])
      (define n 12)
      (define A
        (build-vector n (lambda (i) (build-vector n (lambda (j) (bf (/ 1 (+ i j 1))))))))
      (define x (solutions A (build-vector n (lambda (i) (vector (bf (if (= i 3) 1 0)))))))
      (for* ([i (in-range n)])
        (define sum
          (for/fold ([sum (bf 0)]) ([a (in-vector (vector-ref A i))] [row (in-vector x)])
            (bf+ sum (bf* a (vector-ref row 0)))))
        (check-true (bf< (bfabs (bf- sum (bf (if (= i 3) 1 0)))) (bf 1e-60))))))

  (test-case "several right sides at once, and rows in an order that must change"
    (parameterize ([bf-precision 100])
      (define x (solutions (rows '(0 2) '(4 1)) (rows '(2 6) '(9 -1))))
      (check-equal? (for/list ([row (in-vector x)])
                      (for/list ([v (in-vector row)]) (bigfloat->rational v)))
                    '((2 -1) (1 3)))))

  (test-case "no solution where a column depends on the others, but for rounding"
    (parameterize ([bf-precision 100])
      (check-eq? (solutions (rows '(1 2) '(2 4)) (rows '(1) '(1))) 'singular)
      (define third (bf/ (bf 1) (bf 3)))
      (define A (vector (vector third (bf 1)) (vector (bf 1) (bf 3))))
      (check-eq? (solutions A (rows '(1) '(1))) 'singular))))
