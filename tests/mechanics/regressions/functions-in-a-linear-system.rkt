#lang racket/base
;; solve-linear-left divided functions, and so refused those with tuples as values.

(require mechanics "../support/checks.rkt")

(define (A t) (down (down t 1) (down 1 2)))
(define (b t) (down t (square t)))

(test-case "a system of functions is solved by their values"
  (check-equal? ((solve-linear-left A b) 3) (solve-linear-left (A 3) (b 3)))
  (check-equal? ((solve-linear-right b A) 3) (solve-linear-right (b 3) (A 3)))
  (check-equal? ((solve-linear-left A (down 1 2)) 3) (solve-linear-left (A 3) (down 1 2)))
  (check-equal? ((solve-linear-right (down 1 2) A) 3) (solve-linear-right (down 1 2) (A 3)))
  (check-equal? ((solve-linear-left (A 3) b) 3) (solve-linear-left (A 3) (b 3))))

(test-case "of several arguments, and printed as what was typed"
  (define (B x y) (matrix-by-rows (list x 0) (list 0 y)))
  (check-equal? ((solve-linear-left B (lambda (x y) (up x y))) 2 3) (up 1 1))
  (check-equal? (format "~a" (solve-linear-left A b)) "(solve-linear-left A b)"))
