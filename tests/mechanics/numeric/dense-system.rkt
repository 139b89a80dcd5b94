#lang racket/base
;; Dense systems of flonums, solved in place.

(require racket/flonum
         rackunit
         mechanics/numeric/dense-system)

;; The solution of A x = b, given as rows of [A b].
(define (solution . rows)
  (define n (length rows))
  (define m (apply flvector (apply append rows)))
  (solve-dense! m n)
  (for/list ([k (in-range n)]) (flvector-ref m (+ (* k (+ n 1)) n))))

(test-case "small systems"
  (check-equal? (solution '(2.0 6.0)) '(3.0))
  (check-equal? (solution '(1.0 1.0 3.0) '(1.0 -1.0 1.0)) '(2.0 1.0)))

(test-case "a zero on the diagonal is no obstacle"
  (check-equal? (solution '(0.0 1.0 5.0) '(2.0 0.0 6.0)) '(3.0 5.0)))

(test-case "random systems"
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
