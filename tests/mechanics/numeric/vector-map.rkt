#lang racket/base
;; Vectors mapped, of lengths that are spelled out and of others.

(require mechanics/numeric/vector-map "../support/checks.rkt")

(test-case "vectors of any length are mapped, from first to last"
  (for ([n 6])
    (define v (build-vector n add1))
    (define w (build-vector n (lambda (i) (* 10 i))))
    (define seen '())
    (define (note x) (set! seen (cons x seen)) x)
    (check-equal? (vector-map (lambda (x) (* 2 (note x))) v)
                  (build-vector n (lambda (i) (* 2 (+ i 1)))))
    (check-equal? (reverse seen) (vector->list v))
    (check-equal? (vector-map2 list v w)
                  (build-vector n (lambda (i) (list (+ i 1) (* 10 i)))))))
