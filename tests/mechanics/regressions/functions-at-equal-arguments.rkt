#lang racket/base
;; A literal function has equal values at equal arguments, however these are written; it once
;; had two where one argument was a flonum, or a root that cancels.

(require mechanics "../support/checks.rkt")

(define V (literal-function 'V))
(define F (literal-function 'F (-> (UP Real Real) Real)))

(define (status a b) (verdict-status (prove-zero (- a b))))

(test-case "equal arguments have equal values"
  (check-not-eq? (status (V (* 0.5 'q)) (V (* 1/2 'q))) 'refuted)
  (check-not-eq? (status (V 2) (V 2.0)) 'refuted)
  (check-not-eq? (status (V (expt 2 'half)) (V (/ (* 2 (expt 2 'half)) 2))) 'refuted)
  (check-not-eq? (status (V (asinh (sinh 'x))) (V 'x)) 'refuted))

(test-case "so have derivatives, and functions of tuples"
  (check-not-eq? (status ((D V) (* 0.1 3 'x)) ((D V) (* 0.3 'x))) 'refuted)
  (check-not-eq? (status (F (up (tan (atan 'x)) 1)) (F (up 'x 1))) 'refuted)
  (check-not-eq? (status (V (V (asinh (sinh 'x)))) (V (V 'x))) 'refuted))

(test-case "different arguments have different values"
  (check-eq? (status (V (* 0.5 'q)) (V (* 0.51 'q))) 'refuted)
  (check-eq? (status (V (asinh (sinh 'x))) (V (* 1000001/1000000 'x))) 'refuted)
  (check-eq? (status (F (up 'x 1)) (F (up 1 'x))) 'refuted))
