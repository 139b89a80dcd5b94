#lang racket/base
;; Expressions, simplification and substitution on values of every shape.  What
;; simplification does to one expression is tested with the algebra.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/value/simplify
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt" "../support/random.rkt" "../support/same.rkt"
         "../support/random/element.rkt")

(define x (literal-function 'x))

(test-case "the expression of a value is plain data, unsimplified"
  (check-equal? (expression (up 't (down (g:* 'm (x 't)) 2) (vector 1)))
                '(up t (down (* m (x t)) 2) (up 1)))
  (check-equal? (expression (((g:expt D 2) x) 't)) '(((expt D 2) x) t))
  (check-equal? (expression (g:+ 'a 'a)) '(+ a a))
  (check-equal? (expression (D x)) '(D x))
  (check-equal? (expression 1/2) 1/2))

(test-case "simplification goes into structures and matrices and keeps their shape"
  (define s (up (g:+ 'a 'a) (down (g:- 'b 'b) 3)))
  (check-equal? (expression (simplify s)) '(up (* 2 a) (down 0 3)))
  (check-equal? (expression (simplify (matrix-by-rows (list (g:- 'a 'a) 1))))
                '(matrix-by-rows (list 0 1)))
  (check-equal? (simplify 3) 3)
  (check-eq? (simplify x) x)
  (with-seed 341
    (for ([_ 10])
      (define value ((random-nested random-expression)))
      (check-true (same? (simplify value) value))
      (check-equal? (simplify (simplify value)) (simplify value)))))

(test-case "substitution of symbols and of expressions, all at once"
  (check-true (same? (substitute (g:* 'm (g:square 'v)) 'm 3 'v (g:+ 'a 1))
                     (g:* 3 (g:square (g:+ 'a 1)))))
  (check-equal? (substitute (up 'a (down 'b 1)) 'a 'b 'b 'a) (up 'b (down 'a 1)))
  (check-equal? (substitute (x 't) 't 0) (x 0))
  (check-true (same? (substitute (g:+ (x 't) 1) (x 't) 'q) (g:+ 'q 1)))
  (check-equal? (substitute 5 'a 1) 5)
  (check-equal? (substitute (matrix-by-rows '(a b)) 'a 1) (matrix-by-rows '(1 b))))

(test-case "what cannot be substituted is said"
  (check-exn
   #rx"^substitute: expected an expression, or a tuple or matrix of them\n  given: x, a literal function [(]-> Real Real[)]\n  apply the function first, and substitute in its value$"
   (lambda () (substitute x 'm 3)))
  (check-exn #rx"^substitute: .*given: \"m\", a string$" (lambda () (substitute "m" 'm 3)))
  (check-exn
   #rx"^substitute: .*[(]substitute x 'm 2 'k 3[)]\n  without a replacement: the symbol m$"
   (lambda () (substitute 'm 'm)))
  (check-exn #rx"a symbol or an expression to replace\n  given: the number 3"
             (lambda () (substitute 'm 3 'm)))
  (check-exn #rx"a number or an expression as replacement" (lambda () (substitute 'm 'm (up 1 2))))
  (check-exn #rx"the symbol z; .*: [(]substitute [(][+] y z[)] 'y 'z[)]$"
             (lambda () (substitute 'z 'y (g:+ 'y 'z)))))

(test-case "with-literals binds names to symbols"
  (check-equal? (with-literals (m k) (list m k)) '(m k)))
