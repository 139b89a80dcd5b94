#lang racket/base
;; Factors of matrices, used for several right-hand sides.

(require racket/fixnum racket/flonum
         rackunit
         mechanics/numeric/factored-system)

(define seed 20)
(define generator (make-pseudo-random-generator))
(parameterize ([current-pseudo-random-generator generator]) (random-seed seed))
(define (random-vector n)
  (for/flvector #:length n ([_ (in-range n)]) (- (* 2.0 (random generator)) 1.0)))

(define (product a x n)
  (for/flvector #:length n ([i (in-range n)])
    (for/fold ([sum 0.0]) ([j (in-range n)])
      (+ sum (* (flvector-ref a (+ (* i n) j)) (flvector-ref x j))))))

(test-case "solutions of random systems, several for one matrix"
  (for* ([n (in-range 1 12)] [_ (in-range 5)])
    (define a (random-vector (* n n)))
    (define m (flvector-copy a))
    (define exchanges (make-fxvector n))
    (check-true (factor! m n exchanges))
    (for ([_ (in-range 3)])
      (define x (random-vector n))
      (define b (product a x n))
      (solve-factored! m n exchanges b)
      (for ([u (in-flvector x)] [v (in-flvector b)])
        (check-= u v 1e-9 (format "seed ~a, n = ~a" seed n))))))

(test-case "a zero on the diagonal is no obstacle"
  (define m (flvector 0.0 1.0 0.0  0.0 0.0 1.0  1.0 0.0 0.0))
  (define exchanges (make-fxvector 3))
  (define b (flvector 2.0 3.0 1.0))
  (check-true (factor! m 3 exchanges))
  (solve-factored! m 3 exchanges b)
  (check-equal? b (flvector 1.0 2.0 3.0)))

(test-case "singular matrices, and those with what is no number on the diagonal, have no factors"
  (for ([m (in-list (list (flvector 1.0 2.0 2.0 4.0) (flvector 0.0 0.0 0.0 0.0)
                          (flvector +nan.0 0.0 0.0 1.0) (flvector +inf.0 0.0 0.0 1.0)))])
    (check-false (factor! m 2 (make-fxvector 2)))))
