#lang racket/base
;; Calls that were meant otherwise: what is said where they fail, at the prompt and in modules.

(require racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define-values (output errors)
  (session '("-I" "mechanics")
           "(m * v)"
           "(1/2 * mass * speed^2)"
           "(define (momentum rate) (weight * rate))"
           "(momentum 3)"
           "(define three 3)"
           "(three * 2 + 1)"
           "(2 * sin(4))"
           "(+ unknown(5) 1)"
           "(sin(phi))"
           "(define angle 2)"
           "(cos(angle))"
           "(pi / 2)"
           "((1/2 mass (square speed)) - potential)"
           "(speed = 3)"
           "(2 angle)"
           "(2 breadth height)"
           "(cos(angle/2))"
           "(tan(+ 1 1))"
           "(6)"
           "[1 2]"
           "['x 'y]"
           "{1 2}"
           "[radius 3]"
           "[+ 1 2]"
           "(define (combine f g) (list (f 1 2) (g 3 4)))"
           "(combine * +)"
           "dx/dt"
           "(+ 1 ())"
           "(reduce + 0 (list 1 2))"))

(define (undefined name . hints)
  (string-append name ": undefined;\n cannot reference an identifier before its definition\n"
                 "  in module: top-level\n  " (string-join hints "\n  ") "\n"))

(define (hidden name)
  (format (string-append "; ~a: your definition hides the one of mechanics; "
                         "(require (only-in mechanics ~a)) brings that back\n")
          name name))

(test-case "at the prompt, word for word"
  (check-equal? output '("-2.185039863261519" "3" "'(2 7)"))
  (check-equal?
   (regexp-replace* #rx"stdin:[^ ]*: " errors "")
   (string-append
    (undefined "m" "operations come first: (* m v)" "as a symbol it is written 'm")
    (undefined "mass" "operations come first: (* 1/2 mass (expt speed 2))"
               "as a symbol it is written 'mass")
    (hidden "momentum")
    (undefined "weight" "operations come first: (* weight rate)"
               "as a symbol it is written 'weight")
    "three: operations come first: (+ (* three 2) 1)\n"
    "application: sin(4) is written (sin 4)\n"
    (undefined "unknown" "unknown(5) is written (unknown 5)"
               "as a symbol it is written 'unknown")
    (undefined "phi" "sin(phi) is written (sin phi)" "as a symbol it is written 'phi")
    (hidden "angle")
    "angle: cos(angle) is written (cos angle)\n"
    "pi: operations come first: (/ pi 2)\n"
    (undefined "mass" "operations come first: (- (* 1/2 mass (square speed)) potential)"
               "as a symbol it is written 'mass")
    (undefined "speed" "operations come first: (= speed 3); a definition is (define speed 3)"
               "as a symbol it is written 'speed")
    (string-append "application: the value 2 is a number; it cannot be applied to the argument 2; "
                   "a product is (* 2 2)\n")
    (undefined "breadth" "a product is (* 2 breadth height)" "as a symbol it is written 'breadth")
    (undefined "angle/2" "cos(angle/2) is written (cos (/ angle 2))"
               "a symbol in it is quoted, as 'angle")
    "application: a number is written 6, without parentheses; f(6) is written (f 6)\n"
    "application: brackets are parentheses here; a tuple is (up 1 2)\n"
    "application: brackets are parentheses here; a tuple is (up 'x 'y)\n"
    "application: braces are parentheses here; a tuple is (up 1 2)\n"
    (undefined "radius" "brackets are parentheses here; a tuple is (up radius 3)"
               "as a symbol it is written 'radius")
    (undefined "dx/dt" "the rate of a path x is (D x), at a time ((D x) 't)")
    (lines "#%app: missing procedure expression;"
           " probably originally (), which is an illegal empty application"
           "  in: (#%app)"
           "  f() is written (f); the empty list is '()")
    (undefined "reduce" "did you mean reduce-by-substitution?"
               "as a symbol it is written 'reduce"))))

(test-case "in a module"
  (check-equal? (refusal "(define (p m) (m * speed))")
                (string-append "example:2:19: speed: unbound identifier; operations come first: "
                               "(* m speed); as a symbol it is written 'speed\n  in: speed"))
  (check-equal? (refusal "(+ 1 q(3))")
                (string-append "example:2:5: q: unbound identifier; q(3) is written (q 3); "
                               "as a symbol it is written 'q\n  in: q"))
  (check-equal? (failure "(define (p m v) (m * v))" "(p 2 3)")
                '("" "m: operations come first: (* m v)"))
  (check-equal? (failure "(define x [1 2])")
                '("" "application: brackets are parentheses here; a tuple is (up 1 2)"))
  (check-equal? (failure "(define (f x) (+ x cos(x)))" "(f 2)")
                '("" "x: cos(x) is written (cos x)")))

(test-case "what is right is left as it is"
  (check-equal? (prints "(define (f x) [+ x 1])" "(f(- 3 1))" "(sqrt(square 3))") "3\n3\n"))
