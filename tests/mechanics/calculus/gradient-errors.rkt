#lang racket/base
;; Messages of gradient and its kin on slips: the exact text.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/kind
         mechanics/generic/up-down
         mechanics/calculus/gradient
         "../support/checks.rkt" "../support/messages.rkt")

(define (g x y) (g:* x y))
(define (pair s) (up (g:square (vector-ref (structure-elements s) 0)) 1))

(says
 ;; the value is no scalar
 [((gradient pair) (up 1 2))
  "gradient: needs a function whose value is a scalar; pair returned an up tuple of 2\n"
  "  for the derivatives of all its scalars use jacobian"]
 [((gradient (lambda (s) (list s))) 'x)
  "gradient: needs a function whose value is a scalar; the function returned a list\n"
  "  a list is not a tuple; use (up x y ...)"]
 [((gradient (lambda (s) g:sin)) 'x)
  "gradient: needs a function whose value is a scalar; the function returned a function\n"
  "  for the derivative of a function that returns functions use D"]
 [((gradient void) 'x)
  "gradient: needs a function whose value is a scalar; void returned no value (void)"]

 ;; what is given
 [(gradient 3)
  "gradient: needs a function; 3 is a number\n"
  "  the constant function is (lambda (x) 3)"]
 [(gradient g:sin 'x)
  "gradient: takes one function; it was given 2 arguments, and the arguments of its derivative come after that.\n"
  "  Did you mean ((gradient sin) 'x)?"]
 [(jacobian 'x 't)
  "jacobian: takes one function; it was given 2 arguments, and the arguments of its derivative come after that.\n"
  "  Did you mean ((jacobian x) 't)?"]
 [((gradient g) (up 'x 'y))
  "(gradient g): g takes 2 arguments; it was given one up tuple of 2.\n"
  "  Did you mean ((gradient g) 'x 'y)?"]
 [((gradient pair) "s")
  "gradient: cannot differentiate by \"s\", a string; expected a number or a tuple"]
 [((gradient pair) (up 1 (list 2 3)))
  "gradient: cannot differentiate by (2 3), a list; expected a number or a tuple\n"
  "  a list is not a tuple; use (up x y ...)"]
 [((jacobian pair) (up 1 g:sin))
  "jacobian: cannot differentiate by the procedure `sin`; expected a number or a tuple"]

 ;; products
 [(Hessian-vector-product 3)
  "Hessian-vector-product: needs a function; 3 is a number\n"
  "  the constant function is (lambda (x) 3)"]
 [(Hessian-vector-product g)
  "Hessian-vector-product: needs a function of one argument, the point; g takes 2 arguments\n"
  "  with several arguments, make it a function of the tuple of them"]
 [((Hessian-vector-product pair) (up 1 2) (down 1 2))
  "Hessian-vector-product: the vector must be of the shape of the point\n"
  "  point: (up 1 2), an up tuple of 2\n"
  "  vector: (down 1 2), a down tuple of 2"]
 [((Hessian-vector-product pair) (up 1 2) (up 1 2))
  "Hessian-vector-product: needs a function whose value is a scalar; pair returned an up tuple of 2\n"
  "  for the derivatives of all its scalars use jacobian"]
 [((jacobian-vector-product pair) (up 1 2) 3)
  "jacobian-vector-product: the vector must be of the shape of the point\n"
  "  point: (up 1 2), an up tuple of 2\n"
  "  vector: the number 3"]
 [((vector-jacobian-product pair) (up 1 2) (up 1 2))
  "vector-jacobian-product: the covector must contract with the value to a scalar: a down tuple of 2 goes with an up tuple of 2\n"
  "  value: (up 1 1), an up tuple of 2\n"
  "  covector: (up 1 2), an up tuple of 2"]
 [((vector-jacobian-product g:sin) 'x (up 1 2))
  "vector-jacobian-product: the covector must contract with the value to a scalar\n"
  "  value: (sin x), a number-like expression being differentiated\n"
  "  covector: (up 1 2), an up tuple of 2"])

(test-case "the products take a point and a vector"
  (check-exn exn:fail:contract:arity? (lambda () ((Hessian-vector-product g:sin) 1))))

(test-case "an operation without a rule is named"
  (define generic:odd (generic-op 'odd #f values '() #f '()))
  (check-message "odd: has no derivative rule"
                 ((gradient (lambda (x) ((kind-unary (carrier-kind x)) generic:odd x))) 1.0)))
