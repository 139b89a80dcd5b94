#lang racket/base
;; A symbol that cancels has one value in a witness, wherever it stands; it once
;; had a new one at every occurrence, and true equations were refuted.

(require mechanics "../support/checks.rkt")

(define (status a b) (verdict-status (verify-equal a b)))

(test-case "a true equation with a cancelled symbol is not refuted"
  (define ((L-spring m k l0) (up t x v))
    (- (* 1/2 m (square v)) (* 1/2 k (square (- x l0)))))
  (define (path t) (+ 'l0 (* 'a (cos (* (sqrt 2) t)))))
  (check-not-eq? (verdict-status (verify-solution (L-spring 2 4 'l0) path)) 'refuted)
  (check-not-eq? (status (+ 'q (* 0.1 'x 3)) (+ 'q (* 0.3 'x))) 'refuted)
  (check-not-eq? (status (+ 'q (exp (+ 'a 'b))) (+ 'q (* (exp 'a) (exp 'b)))) 'refuted))

(test-case "the value of a witness is that of the residual there"
  (define (value-of v) (apply substitute (verdict-residual v) (flatten-pairs (verdict-witness v))))
  (define (flatten-pairs alist)
    (apply append (map (lambda (p) (list (car p) (cdr p))) alist)))
  (for ([v (list (verify-equal (+ 'a 1) 'a)
                 (verify-equal (+ 'y 'x 1) 'x)
                 (verify-equal (/ (+ 'a 'b) 'c) (+ (/ 'a 'c) (/ 'b 'd)))
                 (verify-equal (+ (square (sin 'a)) (square (cos 'a))) 2))])
    (check-eq? (verdict-status v) 'refuted)
    (check-= (value-of v) (verdict-value v) 1e-9)))
