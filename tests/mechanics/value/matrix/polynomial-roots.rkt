#lang racket/base
;; Roots of polynomials: those that were multiplied, and what Vieta says of their sums.

(require mechanics
         "../../support/checks.rkt")

(define (with-roots roots) (apply * (for/list ([r roots]) (- 'x r))))

(test-case "the roots of a product are those of its factors, each as often as it is there"
  (for ([roots '((2) (2 3) (0 5) (-1/2 -1/2) (1 2 3) (0 0 7 -7/3) (1 1 2 2 2))])
    (check-equal? (sort (polynomial-roots (expand (with-roots roots)) 'x) <) (sort roots <)))
  (check-equal? (polynomial-roots 7 'x) '()))

(test-case "of a square the roots have the sum −b and the product c, whatever these are"
  (define (value x) (substitute x 'b 2 'c 3 'p 4 'q 5))
  (for* ([b (list 0 3 1.5 'b (+ 'p 'q))] [c (list 2 5 0.3 'c (* 'p 'q))])
    (define found (polynomial-roots (+ (square 'x) (* b 'x) c) 'x))
    (check-equal? (length found) 2)
    (check-= (magnitude (value (+ b (apply + found)))) 0 1e-13)
    (check-= (magnitude (value (- c (apply * found)))) 0 1e-13)))

(test-case "of a higher degree they are decimals at which it vanishes"
  (define (p x) (+ (expt x 5) (* -1 x) -1))
  (define found (polynomial-roots (p 'x) 'x))
  (check-equal? (length found) 5)
  (for ([x found]) (check-true (< (magnitude (p x)) 1e-13))))
