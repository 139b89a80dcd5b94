#lang racket/base
;; Mistakes of a newcomer whose messages spoke of something else, or that passed in silence.

(require mechanics "../support/checks.rkt" "../support/messages.rkt" "../support/run-text.rkt")

(define ((L-mass m) s) (* 1/2 m (square (velocity s))))

(says
 [(matrix-by-rows '((* 2 a) b) '(b (* 2 a)))
  "matrix-by-rows: formulas in a quoted list are not computed; without its quote the row is "
  "(list (* 2 'a) 'b)\n"
  "  given: '((* 2 a) b)"]
 [(matrix-by-columns '(1 (expt x 2)) '(0 1))
  "matrix-by-columns: formulas in a quoted list are not computed; without its quote the row is "
  "(list 1 (expt 'x 2))\n"
  "  given: '(1 (expt x 2))"]
 [(matrix-by-rows '((1 2) (3 4)))
  "matrix-by-rows: each list is an argument of its own: (matrix-by-rows '(1 2) '(3 4))\n"
  "  given: '((1 2) (3 4))"]
 [(definite-integral sin 'x 0 1)
  "definite-integral: expected a function and two ends; the function says which variable is meant: "
  "(definite-integral f 0 1)\n"
  "  given: x, 0 and 1 after it"]
 [(definite-integral exp 'u 'a 'b)
  "definite-integral: expected a function and two ends; the function says which variable is meant: "
  "(definite-integral f a b)\n"
  "  given: u, a and b after it"]
 [(definite-integral 'x+1 0 1)
  "definite-integral: expected a function of one variable\n"
  "  given: the symbol x+1\n"
  "  x+1 is one name; a function is (lambda (x) (+ x 1))"]
 [(find-root 'x^2-1 0 3)
  "find-root: expected a function of one variable\n"
  "  given: the symbol x^2-1\n"
  "  x^2-1 is one name; a function is (lambda (x) (+ x 1))"]
 [(verify-equilibrium (L-mass 'm) (up 't 'x 'v))
  "verify-equilibrium: expected coordinates\n"
  "  given: (up t x v), a local tuple\n"
  "  its coordinates are x"]
 [(equilibrium-stability (L-mass 'm) (up 't (up 'x 'y) (up 'vx 'vy)))
  "equilibrium-stability: expected coordinates\n"
  "  given: (up t (up x y) (up vx vy)), a local tuple\n"
  "  its coordinates are (up x y)"])

(test-case "an end may be a symbol, and have a tolerance after it"
  (check-equal? (expression (definite-integral cos 'a 'b 1e-8)) '(- (sin b) (sin a)))
  (check-equal? (expression (definite-integral cos 0 'b)) '(sin b)))

(test-case "an integral of numbers without a formula has its number"
  (check-message
   (string-append "verify-integral: no formula was found for the integral of (exp (sin x))\n"
                  "  its number is (definite-integral f 0 1)")
   (verify-integral (lambda (x) (exp (sin x))) 0 1 2)
   exn:fail?)
  (check-message
   (string-append "verify-integral: no formula was found for the integral of (exp (sin (* a x)))\n"
                  "  give its symbols values first: (substitute expression 'm 3 ...)")
   (verify-integral (lambda (x) (exp (sin (* 'a x)))) 0 1 2)
   exn:fail?))

(test-case "no root is seen, whatever the derivative is"
  (check-message
   (string-append "find-root: no root seen: the derivative is 0 here, and the value is not\n"
                  "  at: 0.0\n"
                  "  values there: '(1.0)")
   (find-root (lambda (x) (+ 1 (square x))) 1)
   exn:fail:mechanics?))

(test-case "names as in print"
  (check-regexp-match #rx"a power comes first, as in \\(expt \\(sin x\\) 2\\)"
                      (refusal "(define (f x) (* x (sin x)^2))"))
  (check-regexp-match #rx"infinity is [+]inf.0, its opposite -inf.0"
                      (refusal "(definite-integral exp :-infinity 0)"))
  (check-regexp-match #rx"infinity is [+]inf.0" (refusal "(definite-integral exp 0 :+infinity)")))
