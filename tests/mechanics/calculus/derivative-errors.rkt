#lang racket/base
;; Messages of D and partial on slips: the exact text.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/value/signature
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt" "../support/messages.rkt")

(define (g x y) (g:* x y))
(define (h s) (ref-0 s))
(define (ref-0 s) (vector-ref (structure-elements s) 0))
(define (k x [y 1] [z 2]) (g:* x y z))
(define V (literal-function 'V))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real) Real)))

;; ---------------------------------------------------------------------------
;; The number of arguments of the operators

(says
 [(D 'x 't)
  "D: takes one function; it was given 2 arguments, and the arguments of its derivative come after that.\n"
  "  Did you mean ((D x) 't)?"]
 [((partial 0) g:sin 'x)
  "(partial 0): takes one function; it was given 2 arguments, and the arguments of its derivative come after that.\n"
  "  Did you mean (((partial 0) sin) 'x)?"]
 [(D g:sin g:cos) "D: takes one function; it was given 2 arguments"]
 [((partial 0)) "(partial 0): takes one function; it was given no argument"]
 [((D 'x 't))
  "D: takes one function; it was given 2 arguments, and the arguments of its derivative come after that.\n"
  "  Did you mean ((D x) 't)?"])

;; ---------------------------------------------------------------------------
;; The number of arguments

(says
 [((D g) (up 'x 'y))
  "(D g): g takes 2 arguments; it was given one up tuple of 2.\n"
  "  Did you mean ((D g) 'x 'y)?"]
 [((D g) (down 1 (up 'x 2)))
  "(D g): g takes 2 arguments; it was given one down tuple of 2.\n"
  "  Did you mean ((D g) 1 (up 'x 2))?"]
 [((D g) (g:sin 'x))
  "(D g): g takes 2 arguments; it was given 1 argument, (sin x)"]
 [((D g) 1 2 3)
  "(D g): g takes 2 arguments; it was given 3 arguments"]
 [((D g) (up 1 2 3))
  "(D g): g takes 2 arguments; it was given one up tuple of 3"]
 [((D h) 'x 'y)
  "(D h): h takes 1 argument; it was given 2 arguments.\n"
  "  Did you mean ((D h) (up 'x 'y))?"]
 [((D g))
  "(D g): g takes 2 arguments; it was given 0 arguments"]
 [((D g:sin))
  "(D sin): sin takes 1 argument; it was given 0 arguments"]
 [((D g:sin) 'x 'y)
  "(D sin): sin takes 1 argument; it was given 2 arguments"]
 [((D V) 'x 'y)
  "(D V): V takes 1 argument; it was given 2 arguments"]
 [((D (lambda () 3)))
  "(D <function>): needs at least one argument, to differentiate by; it was given none"]
 [(((partial 0) g:+))
  "((partial 0) +): needs at least one argument, to differentiate by; it was given none"]
 [((D k))
  "(D k): k takes 1 to 3 arguments; it was given 0 arguments"]
 [((D F) (up 'x (g:* 2 'y)))
  "(D F): F takes 2 arguments; it was given one up tuple of 2.\n"
  "  Did you mean ((D F) 'x (* 2 'y))?"]
 [(((partial 0) g) (up 'x 'y))
  "((partial 0) g): g takes 2 arguments; it was given one up tuple of 2.\n"
  "  Did you mean (((partial 0) g) 'x 'y)?"]
 [(((partial 1) G) 'x 'y)
  "((partial 1) G): G takes 1 argument; it was given 2 arguments.\n"
  "  Did you mean (((partial 1) G) (up 'x 'y))?"])

(test-case "an anonymous function is not given a place in a file"
  (check-exn #rx"^[(]D <function>[)]: <function> takes 2 arguments"
             (lambda () ((D (lambda (x y) x)) 1))))

;; ---------------------------------------------------------------------------
;; Arguments that are no functions

(says
 [(D 3)
  "D: needs a function; 3 is a number\n  the constant function is (lambda (x) 3)"]
 [((D 3) 'x)
  "D: needs a function; 3 is a number\n  the constant function is (lambda (x) 3)"]
 [(D 'x)
  "D: needs a function; x is a number-like expression\n"
  "  the constant function is (lambda (t) 'x), an unknown one (literal-function 'x)"]
 [(D (g:sin 'x))
  "D: needs a function; (sin x) is a number-like expression\n"
  "  the function with this value is (lambda (x) (sin x))"]
 [(D (list V V))
  "D: needs a function; (V V) is a list\n  a list is not a tuple; use (up x y ...)"]
 [(D (matrix-by-rows '(1 2)))
  "D: needs a function; (matrix-by-rows (list 1 2)) is a 1 by 2 matrix"]
 [((partial 1) 'F)
  "(partial 1): needs a function; F is a number-like expression\n"
  "  the constant function is (lambda (t) 'F), an unknown one (literal-function 'F)"])

(says
 [((D (up V 3)) 't)
  "application: a tuple applies its components to the arguments, but the component 3 of (up V 3) is not a function; (constant-function 3) makes a function of it\n  a component is (ref s 0)"])

;; ---------------------------------------------------------------------------
;; Indices

(says
 [(partial 0 F)
  "partial: takes only indices; the function comes next: ((partial 0) F)"]
 [((partial 0 F) 'x 'y)
  "partial: takes only indices; the function comes next: ((partial 0) F)"]
 [(partial F)
  "partial: takes only indices; the function comes next: ((partial) F)"]
 [(partial) "partial: needs at least one index, as in (partial 0)"]
 [(partial -1) "partial: an index is a natural number; given -1"]
 [(partial 'x) "partial: an index is a natural number; given x"]
 [(partial 1.0) "partial: an index is a natural number; given 1.0"]
 [(((partial 2) g) 'x 'y)
  "(partial 2): there is no such component in (up x y), an up tuple of 2 (indices 0 to 1)"]
 [(((partial 3) h) (up 't 'q 'v))
  "(partial 3): there is no such component in (up t q v), an up tuple of 3 (indices 0 to 2)"]
 [(((partial 1 2) h) (up 't (up 'x 'y) (up 'vx 'vy)))
  "(partial 1 2): there is no such component in (up x y), an up tuple of 2 (indices 0 to 1)"]
 [(((partial 1 0) h) (up 't 'q 'v))
  "(partial 1 0): there is no such component in q, a number-like expression"]
 [(((partial 0) V) 'x)
  "(partial 0): there is no such component in x, a number-like expression\n"
  "  the derivative of a function of one number is (D f)"]
 [(((partial 0) h) (up))
  "(partial 0): there is no such component in (up), an up tuple of 0"])

;; ---------------------------------------------------------------------------
;; Points and values

(says
 [((D h) '(1 2))
  "D: cannot differentiate by (1 2), a list; expected a number or a tuple\n"
  "  a list is not a tuple; use (up x y ...)"]
 [((D h) V)
  "D: cannot differentiate by V, a literal function (-> Real Real); expected a number or a tuple"]
 [((D h) "x")
  "D: cannot differentiate by \"x\", a string; expected a number or a tuple"]
 [((D (lambda (x) (list x x))) 't)
  "D: the function returned a value that has no derivative: (t t), a list\n"
  "  a list is not a tuple; use (up x y ...)"]
 [((D (lambda (x) (void))) 't)
  "D: the function returned a value that has no derivative: #<void>, no value (void)"]
 [((D (lambda (x) #t)) 't)
  "D: the function returned a value that has no derivative: #t, a boolean"])

(test-case "an error within the function shows values, never dual numbers"
  (check-exn
   #rx"argument 1: x, a number-like expression being differentiated\n  argument 2: [(]up 1 2[)]"
   (lambda () ((D (lambda (x) (g:+ x (up 1 2)))) 'x))))
