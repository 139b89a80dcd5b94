#lang racket/base
;; How values print and how messages name them.

(require mechanics/algebra/expression/write
         mechanics/generic/arithmetic
         mechanics/generic/cyclic-data
         mechanics/generic/describe
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/calculus/derivative
         mechanics/calculus/dual
         mechanics/calculus/literal-function
         mechanics/value/signature
         "../support/checks.rkt")

(test-case "every kind of value has a description"
  (for ([x (list 3 'a (g:sin 'a) (up 1 2) (down 1) (vector 1 2) sin (g:+ sin cos) D
                 (literal-function 'f (-> (UP Real Real) Real)) (matrix-by-rows '(1 2))
                 (make-dual 1 2 3) '(1) "s" #f (void) (box 1))]
        [text '("a number" "a number-like expression" "a number-like expression"
                "an up tuple of 2" "a down tuple of 1" "an up tuple of 2" "a function" "a function"
                "an operator" "a literal function (-> (UP Real Real) Real)" "a 1 by 2 matrix"
                "a number being differentiated" "a list" "a string" "a boolean" "no value (void)"
                "a value that is no part of the arithmetic")])
    (check-equal? (describe x) text)))

(test-case "a description with the value"
  (for ([x (list 3 'a (g:sin 'a) (up 1 2) g:sin (lambda (x) x) '(1 a) "s")]
        [text '("the number 3" "the symbol a" "(sin a), a number-like expression"
                "(up 1 2), an up tuple of 2" "the procedure `sin`" "a function without a name"
                "(1 a), a list" "\"s\", a string")])
    (check-equal? (describe-with-value x) text)))

(test-case "a value prints as its S-expression, and a dual number as its value alone"
  (check-equal? (value->datum (up 't (vector 1 (g:* 'm (g:sin 'x)))))
                '(up t (up 1 (* m (sin x)))))
  (check-equal? (value->text (make-dual 2 (make-dual 1 'x 1) 'y)) "x")
  (check-equal? (value->text (up (make-dual 1 'x 1) 2)) "(up x 2)")
  (check-equal? (value->datum (list 1 (up 2) 'a)) '(1 (up 2) a)))

(test-case "symbols are written as symbols that need it are"
  (check-equal? (value->text (up 'v_r^x 'θ '|two words|)) "(up v_r^x θ |two words|)"))

(test-case "a value of exponential size prints within bounds"
  (define large (for/fold ([x 'x]) ([_ 60]) (g:sin (g:* x (g:+ x 1)))))
  (define text (parameterize ([print-limit 50]) (value->text large)))
  (check-true (< (string-length text) 3000))
  (check-regexp-match #rx"more" text))

(test-case "leaves are the scalars of containers, and everything else itself"
  (define (add1-leaf x) (g:+ x 1))
  (check-equal? (map-leaves add1-leaf (up 1 (down 2 'a))) (up 2 (down 3 (g:+ 1 'a))))
  (check-equal? (map-leaves add1-leaf (vector 1 (up 2))) (vector 2 (up 3)))
  (check-equal? (map-leaves add1-leaf (matrix-by-rows '(1 2))) (matrix-by-rows '(2 3)))
  (check-equal? (map-leaves add1-leaf 5) 6))

(test-case "data that contain themselves are known; what is shared alone does not"
  (define v (vector 'a 0))
  (vector-set! v 1 (list 'b v))
  (check-true (cyclic? v))
  (check-true (cyclic? (list 1 (cons 'a v))))
  (define shared (vector 1 2))
  (check-false (cyclic? (list shared shared (vector shared)))))
