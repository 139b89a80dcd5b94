#lang racket/base
;; Pixels of a picture and points of the plane.

(require racket/flonum
         mechanics/show/plot/pixels
         "../../support/checks.rkt")

(define-values (across down) (values 7 5))
(define (picture) (make-pixels '(2.0 3.0 -5.0 -1.0) across down))

(define (marked p)
  (for*/list ([j down] [i across]
              #:unless (= 0 (bytes-ref (pixels-bytes p) (* 4 (+ i (* j across))))))
    (list i j)))

(test-case "the point in the middle of a pixel is in it, and marks it alone"
  (for* ([i across] [j down])
    (define p (picture))
    (define-values (x y) (pixel->point p i j))
    (check-equal? (call-with-values (lambda () (point->pixel p x y)) list) (list i j))
    (mark! p (flvector x) (flvector y) 1 '(10 20 200) 1)
    (check-equal? (marked p) (list (list i j)))))
