#lang racket/base
;; Singular values of columns of flonums.

(require racket/flonum
         mechanics/numeric/flvector
         mechanics/numeric/linear-algebra/singular-values
         "../../support/checks.rkt")

(define (check-decomposition columns)
  (define-values (us sizes vs) (singular-values columns))
  (check-true (apply >= sizes))
  (for* ([list-of (list us vs)] [(u i) (in-indexed list-of)] [(w j) (in-indexed list-of)])
    (check-= (dot u w) (if (= i j) 1.0 0.0) 1e-14))
  ;; column j is the sum of s u v_j
  (for* ([(column j) (in-indexed columns)] [i (in-range (flvector-length column))])
    (check-= (for/sum ([u us] [s sizes] [v vs]) (* s (flvector-ref u i) (flvector-ref v j)))
             (flvector-ref column i) 1e-13)))

(define (in-indexed xs) (in-parallel xs (in-naturals)))

(test-case "the columns are put together again"
  (check-decomposition (list (flvector 3.0 4.0) (flvector 0.0 5.0)))
  (check-decomposition (list (flvector 1.0 0.01) (flvector 0.01 1.0)))
  (check-decomposition (list (flvector 1.0 2.0 3.0) (flvector 4.0 5.0 6.0)))
  (check-decomposition (list (flvector 1.0 4.0 7.0) (flvector 2.0 5.0 8.0)
                             (flvector 3.0 6.0 10.0))))

(test-case "the values are known: 3√5 and √5, whatever the unit"
  (for ([unit '(1.0 1e-30 1e30)])
    (define-values (us sizes vs)
      (singular-values (list (flvector (* 3.0 unit) (* 4.0 unit)) (flvector 0.0 (* 5.0 unit)))))
    (check-= (/ (car sizes) unit) (* 3 (sqrt 5.0)) 1e-14)
    (check-= (/ (cadr sizes) unit) (sqrt 5.0) 1e-14)))

(test-case "a small value beside a great one keeps its digits"
  (define-values (us sizes vs)
    (singular-values (list (flvector 1e10 0.0) (flvector 0.0 1e-10))))
  (check-equal? sizes '(1e10 1e-10)))

(test-case "columns that depend on each other have a value of nothing"
  (define-values (us sizes vs) (singular-values (list (flvector 1.0 2.0) (flvector 2.0 4.0))))
  (check-= (car sizes) 5.0 1e-14)
  (check-= (cadr sizes) 0.0 1e-15))

(test-case "a column of zeros gets a direction of its own"
  (define-values (us sizes vs) (singular-values (list (flvector 0.0 0.0) (flvector 3.0 4.0))))
  (check-equal? sizes '(5.0 0.0))
  (check-= (norm (cadr us)) 1.0 1e-15)
  (check-= (dot (car us) (cadr us)) 0.0 1e-15))

(test-case "so do columns of which nothing but roundings is left"
  (for ([columns (list (list (flvector 0.0 0.0) (flvector 0.0 0.0))
                       (list (flvector 1.0 2.0) (flvector 2.0 4.0))
                       (list (flvector 1.0 4.0 7.0) (flvector 2.0 5.0 8.0)
                             (flvector 3.0 6.0 9.0))
                       (list (flvector 1.0 1.0 1.0 1.0) (flvector 0.1 0.1 0.1 0.1)
                             (flvector 0.3 0.3 0.3 0.3))
                       (list (flvector 0.1 0.2 0.3) (flvector 0.7 1.4 2.1)
                             (flvector 1e-300 0.0 1e-300)))])
    (check-decomposition columns)))
