#lang racket/base
;; Factors of matrices, used for several right-hand sides.

(require racket/fixnum
         racket/flonum
         racket/list
         mechanics/numeric/linear-algebra/factored-system
         "../../support/checks.rkt")

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

;; ---------------------------------------------------------------------------
;; One right-hand side

;; The solution of A x = b, given as rows of [A b].
(define (solution . rows)
  (define n (length rows))
  (define (entries select) (apply flvector (append* (map select rows))))
  (define x (entries (lambda (row) (take-right row 1))))
  (solve-dense! (entries (lambda (row) (drop-right row 1))) n (make-fxvector n) x)
  (for/list ([u (in-flvector x)]) u))

(test-case "small systems"
  (check-equal? (solution '(2.0 6.0)) '(3.0))
  (check-equal? (solution '(1.0 1.0 3.0) '(1.0 -1.0 1.0)) '(2.0 1.0)))

(test-case "nor is it for one right-hand side"
  (check-equal? (solution '(0.0 1.0 5.0) '(2.0 0.0 6.0)) '(3.0 5.0)))

(test-case "random systems with one right-hand side"
  (for ([seed (in-range 1 40)])
    (random-seed seed)
    (define n (+ 1 (random 20)))
    (define A (for/list ([i n]) (for/list ([j n]) (- (random) 0.5))))
    (define x (for/list ([j n]) (- (random) 0.5)))
    (define b (for/list ([row A]) (apply + (map * row x))))
    (define found (apply solution (for/list ([row A] [c b]) (append row (list c)))))
    (check-true (for/and ([u x] [v found]) (< (abs (- u v)) 1e-9)) (format "seed ~a" seed))))

(test-case "of a singular matrix nothing is a number"
  (check-equal? (solution '(1.0 2.0 1.0) '(2.0 4.0 1.0)) '(+nan.0 +nan.0)))
