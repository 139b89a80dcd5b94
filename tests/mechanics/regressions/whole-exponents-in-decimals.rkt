#lang racket/base
;; Derivatives of (x - 2)^4.0 at 2.0 were no numbers from the fifth on: 0.0 times 0.0 to the power
;; of -1.  And its powers were taken for kinks where they are smooth.

(require mechanics "../support/checks.rkt" "../support/close.rkt")

(define (derivatives f x n) (for/list ([k (in-range (add1 n))]) (((expt D k) f) x)))

(test-case "at the zero of the base, of all orders, as with exact exponents"
  (for* ([m '(0 1 2 4 7)] [x '(2 2.0)])
    (define (decimal x) (expt (- x 2) (exact->inexact m)))
    (define (exact x) (expt (- x 2) m))
    (for ([a (derivatives decimal x 9)] [b (derivatives exact x 9)]) (check-= a b 0))
    (check-= ((D (D (D (D (D decimal))))) x) ((D (D (D (D (D exact))))) x) 0)))

(test-case "inside of others, and in several variables"
  (define (f x) (sin (+ x (expt x 3.0))))
  (define (g x) (sin (+ x (expt x 3))))
  (for ([a (derivatives f 0.0 8)] [b (derivatives g 0.0 8)]) (check-= a b 1e-9))
  (define (h v) (expt (- (ref v 0) (ref v 1)) 2.0))
  (define (exact-h v) (square (- (ref v 0) (ref v 1))))
  (for ([n 4])
    (check-close (((expt D n) h) (up 1.0 1.0)) (((expt D n) exact-h) (up 1.0 1.0)) 1e-15)))

(test-case "what has no derivative has none"
  (check-exn #rx"no derivative" (lambda () (((expt D 3) (lambda (x) (expt x 2.5))) 0)))
  (check-exn #rx"no derivative|undefined" (lambda () ((D (lambda (x) (expt x -1.0))) 0))))

(test-case "symbols: the same formulas"
  (check-pred proved? (verify-equal (((expt D 5) (lambda (x) (expt (- x 'a) 6.0))) 'x)
                                    (* 720 (- 'x 'a))))
  (check-= (simplify (((expt D 4) (lambda (x) (expt (- x 'a) 4.0))) 'a)) 24 0))
