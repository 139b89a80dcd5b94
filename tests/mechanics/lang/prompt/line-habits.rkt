#lang racket/base
;; Lines that were meant as one form.

(require mechanics/lang/unknown-name/known-name
         mechanics/lang/paper-notation/line-habits
         mechanics/lang/prompt/typed-forms
         racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define space (make-base-namespace))
(parameterize ([current-namespace space])
  (namespace-require 'mechanics)
  (eval '(define (f x) x))
  (eval '(define three 3)))

(define-check (check-line text said)
  (define found (parameterize ([current-namespace space])
                  (meant-as-one (forms-in text) known-name? function-name?)))
  (unless (equal? found said)
    (with-check-info (['text text] ['expected said] ['found found]) (fail-check))))

(test-case "calls as on paper"
  (check-line "f(3)" "f(3) is written (f 3)")
  (check-line "sin( 'x )" "sin('x) is written (sin 'x)")
  (check-line "f(g(3))" "f(g(3)) is written (f (g 3))")
  (check-line "L(t,q,v)" "L(t,q,v) is written (L t q v)")
  (check-line "f(x + 1)" "f(x + 1) is written (f (+ x 1))")
  (check-line "f()" "f() is written (f)")
  (check-line "sin x" "a call stands in parentheses: (sin x)")
  (check-line "* 2 'x" "a call stands in parentheses: (* 2 'x)"))

(test-case "definitions"
  (check-line "x = 3" "a definition is written (define x 3)")
  (check-line "x := 3" "a definition is written (define x 3)")
  (check-line "E = m g h" "a definition is written (define E (* 'm 'g 'h))")
  (check-line "E = 2 three" "a definition is written (define E (* 2 three))")
  (check-line "x(t) = A cos(omega t)"
              "a definition is written (define ((x A omega) t) (* A (cos (* omega t))))")
  (check-line "L = 1/2 m v^2 - 1/2 k x^2"
              (string-append
               "a Lagrangian is a function of (up t q v): (define ((L m k) (up t x v)) "
               "(- (* 1/2 m (expt v 2)) (* 1/2 k (expt x 2))))"))
  (check-line "f(x, y) = x*y" "a definition is written (define (f x y) (* x y))")
  (check-line "x=A*cos(w*t)"
              "a definition is written (define ((x A w) t) (* A (cos (* w t))))")
  (check-line "x=3" "a definition is written (define x 3)")
  (check-line "f(x)=x^2" "a definition is written (define (f x) (expt x 2))")
  (check-line "def f(x): return x**2" "a definition is written (define (f x) (expt x 2))")
  (check-line "f = lambda x, y: x*y" "a definition is written (define (f x y) (* x y))")
  (check-line "define proposed(t) A*cos(omega*t)"
              "a definition is written (define (proposed t) (* A (cos (* omega t))))")
  (check-line "m += 1" "a definition is written (define m (+ m 1))")
  (check-line "x1=3, y1=4"
              "no comma separates definitions; each has a line of its own, as (define x 3)")
  (check-line "a, b = 1, 2"
              "no comma separates definitions; each has a line of its own, as (define x 3)")
  (check-line "let x = 3" "a definition is written (define x 3)")
  (check-line "define m = 3" "a definition is written (define m 3)")
  (check-line "string=?" #f)
  (check-line "define (g x) (* x x)" "it stands in parentheses: (define (g x) (* x x))")
  (check-line "require mechanics/plot" "it stands in parentheses: (require mechanics/plot)"))

(test-case "a formula is read from its beginning to its end, products from left to right"
  (check-line "1/2 m v^2" "operations come first: (* 1/2 m (expt v 2))")
  (check-line "(1/2)*m*v^2" "operations come first: (* 1/2 m (expt v 2))")
  (check-line "a / b * c" "operations come first: (* (/ a b) c)")
  (check-line "cos(w*t)/2*3" "operations come first: (* (/ (cos (* w t)) 2) 3)")
  (check-line "V(x) = 1/2*k*x^2"
              "a definition is written (define ((V k) x) (* 1/2 k (expt x 2)))")
  (check-line "L = ½ m (ẋ² + ẏ²)"
              (string-append "a Lagrangian is a function of (up t q v): "
                             "(define ((L m) (up t (up x y) (up xdot ydot))) "
                             "(* 1/2 m (+ (expt xdot 2) (expt ydot 2))))"))
  (check-line "\\frac{1}{2} m \\dot{x}^2" "operations come first: (* 1/2 m (expt xdot 2))"))

(test-case "what two readers could read differently is not translated"
  (define said "operations come first, as in (* 2 x)")
  (for ([text '("p^2/2m + V" "sin x/2 + 1" "E - mgh / 2" "k(x - x0)^2/2" "x^1/2 + y" "n! + 1 / 2")])
    (check-line text said))
  (check-line "|x - y|"
              "bars stand around a name with spaces in it; an absolute value is (abs x)")
  (check-line "k*|x|" said)
  (check-equal? (prime-alone "m*x''") said))

(test-case "Mathematica's and Python's ways"
  (check-line "Sin[x]" "a call stands in parentheses: (sin x)")
  (check-line "2 Pi Sqrt[l/g]" "operations come first: (* 2 pi (sqrt (/ l g)))")
  (check-line "D[Sin[x], x]"
              "a derivative is that of a function: ((D (lambda (x) (sin x))) 'x)")
  (check-line "D[f]" "the derivative of a function f is (D f), a partial one ((partial 0) f)")
  (check-line "Solve[x^2 == 1, x]"
              (string-append "Solve: roots are found by (find-root f low high), "
                             "linear systems solved by solve-linear-left"))
  (check-line "f[x_] := x^2" "a definition is written (define (f x) (expt x 2))")
  (check-line "lambda x: x**2" "a function is written (lambda (x) (expt x 2))")
  (check-line "f = @(x) x.^2" "a definition is written (define (f x) (expt x 2))"))

(test-case "operations and primes"
  (check-line "m * v" "operations come first: (* m v)")
  (check-line "p^2/(2m)" "operations come first: (/ (expt p 2) (* 2 m))")
  (check-line "1 < 2 < 3" "operations come first: (< 1 2 3)")
  (check-line "1 + 2" "operations come first: (+ 1 2)")
  (define said "a prime is read as a quote; the derivative of x is (D x)")
  (check-line "x'(t)" said)
  (check-equal? (prime-alone "x'") said)
  (check-equal? (prime-alone "  x'' ") said)
  (check-equal? (prime-alone "F = -c x'") said)
  (check-equal? (prime-alone "'x'") "a quote stands before a name, and none behind it: 'x")
  (check-false (prime-alone "(list '"))
  (check-false (prime-alone "'")))

(test-case "numbers, and commands of TeX"
  (check-line "6.67 × 10^-11" "it is written 6.67e-11")
  (check-line "\\frac12" "it is written 1/2")
  (check-line "\\dot x" "it is written xdot")
  (check-line "\\dot\\theta" "it is written thetadot")
  (check-line "\\alpha" #f)
  (check-line "A \\cos\\omega t" "operations come first, as in (* 2 x)")
  (check-line "\\partial L" "operations come first, as in (* 2 x)"))

(test-case "lines that were printed"
  (check-line "> (+ 1 2)" "> is the prompt's, not part of what is typed: (+ 1 2)")
  (check-line "zero if: k = 3" "zero ... is a line that was printed, nothing to type")
  (check-line "proved: the residual is zero"
              "proved: ... is a line that was printed, nothing to type"))

(test-case "names and signs of other programs"
  (check-line "import math" "import: a library is loaded by (require mechanics/plot)")
  (check-line "d/dx(x^2)" (string-append "d/dx: the derivative of a function f is (D f), "
                                         "a partial one ((partial 0) f)"))
  (check-line "sin^2(x)" "sin^2: powers come outside: (square (sin x))")
  (check-line "x[0]" "a component is (ref x 0)")
  (check-line "(up 1 2)[0]" "a component is (ref (up 1 2) 0)")
  (for ([line '("// a comment" "-- so" "/* so */" "% so")])
    (check-line line "a comment begins with a semicolon")))

(test-case "several forms in a line may be meant"
  (check-line "1 (+ 'a 'a)" #f)
  (check-line "(define a 1)(define b 2)" #f)
  (check-line "(define a 1) a" #f)
  (check-line "(define q 3) (* 2 q) q" #f)
  (check-line "'a 'b" #f)
  (check-line "three three" #f)
  (check-line "f\n(f 3)" #f)
  (check-line "f" #f)
  (check-line "" #f))

(test-case "the prompt says so, and evaluates nothing of the line"
  (define-values (output errors)
    (session '("-l" "mechanics/lang/prompt/start")
             "(define (f x) (* x x))" "f(3)" "x'" "x = 3" "(begin (display 'seen) 1) (f 2)"
             "(+ 1 1)"))
  (check-equal? (cddr output) '("seen1" "4" "2"))
  (check-equal? errors
                (lines "prompt: f(3) is written (f 3)"
                       "prompt: a prime is read as a quote; the derivative of x is (D x)"
                       "prompt: a definition is written (define x 3)")))

;; ---------------------------------------------------------------------------
;; Words that are commands elsewhere

(define ask (open-prompt "-l" "mechanics/lang/prompt/start"))
(define-values (banner _) (ask))

;; At one prompt for all, which no input leaves.
(define (answers-of . input)
  (define-values (output errors) (apply ask input))
  (check-equal? errors "")
  output)

(test-case "help and ? are commands"
  (define commands (answers-of ",help"))
  (for ([line '("help" "help()" "?" " ? ")]) (check-equal? (answers-of line) commands line))
  (define card (answers-of "(help cube)"))
  (for ([line '("help cube" "? cube" "?cube")]) (check-equal? (answers-of line) card line))
  (define found (answers-of "(help \"Noether\")"))
  (check-equal? (answers-of "help \"Noether\"") found)
  (for ([answers (list commands card found)] [line '(#rx"^," #rx"cube" #rx"Noether")])
    (check-true (ormap (lambda (a) (regexp-match? line a)) answers))))

(test-case "quit and exit leave, unless they are the reader's"
  (for ([line '("quit" "exit" "bye" "quit()" "exit ( )")])
    (define-values (output errors)
      (session '("-l" "mechanics/lang/prompt/start") "1" line "2"))
    (check-equal? (list (cddr output) errors) '(("1") "") line))
  (check-equal? (answers-of "(define quit 3)" "quit" "(+ quit 1)") '("3" "4")))

(test-case "other words are none"
  (check-true (string-contains? (car (answers-of "(define help? 3)" "help?")) "3")))
