#lang racket/base
;; Values that fill one place of a tuple, and others.

(require mechanics/calculus/derivative
         mechanics/calculus/dual
         mechanics/calculus/Taylor-number
         mechanics/calculus/literal-function
         mechanics/generic/arithmetic
         mechanics/generic/scalar
         mechanics/generic/up-down
         mechanics/value/bigfloat
         mechanics/value/matrix/matrix
         mechanics/value/series/series-access
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define plain (list 0 1 1/2 0.5 1+2i +nan.0))
(define open (list 'x (g:+ 'x 1) ((literal-function 'f) 't) (make-dual 1 2 3) (displaced 1 4 'x)))
(define others
  (list (up 1 2) (down 1) (vector 1 2) (matrix-by-rows '(1)) sin (g:+ sin cos) D
        (literal-function 'f) (series 1 2) '(1) "s" #f (void)))

(test-case "numbers and expressions are scalars, also while they are differentiated"
  (for ([x (append plain open)]) (check-true (scalar? x)))
  (for ([x others]) (check-false (scalar? x))))

(test-case "what has no derivatives and no symbols is a plain number"
  (for ([x plain]) (check-true (plain-number? x)))
  (for ([x (append open others)]) (check-false (plain-number? x))))

(skip-unless bigfloats? no-bigfloats
  (test-case "numbers of higher precision are both"
    (check-true (scalar? (bigfloat 1)))
    (check-true (plain-number? (bigfloat 1)))))
