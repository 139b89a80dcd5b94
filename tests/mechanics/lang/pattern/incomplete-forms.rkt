#lang racket/base
;; Definitions and procedures that lack something, or have what is no name where one belongs.

(require (only-in racket/string string-split)
         "../../support/checks.rkt" "../../support/run-text.rkt")

;; The first line of what is said of a form, without its place.
(define (said form)
  (cadr (regexp-match #rx"^example:2:[0-9]*: ([^\n]*)" (refusal form))))

(test-case "definitions"
  (for ([(form message)
         (hash "(define)" "define: a definition is written (define x 3)"
               "(define x)" "define: x has no value; a definition is written (define x 3)"
               "(define 3 x)" "define: 3 is no name; a definition is written (define x 3)"
               "(define x 3 4)" "define: x has one value, and here are several expressions"
               "(define x 1,5)" "define: x has one value, and a decimal has a point, as in 1.5"
               "(define f (x) (* 2 x))"
               (string-append "define: f has one value, and here are several expressions; "
                              "a function is written (define (f x) (* 2 x))")
               "(define L (m, k) 3)" "define: a definition is written (define (L m k) 3)"
               "(define (3 x) x)"
               "define: 3 is no name; a function is defined as in (define (f x) (* 2 x))"
               "(define (f x))"
               (string-append "define: no expressions for procedure body; "
                              "it is written (define (f x) (* 2 x))"))])
    (check-equal? (said form) message)))

(test-case "arguments"
  (for ([(form message)
         (hash "(define (f x, y) (+ x y))"
               "define: no comma separates arguments: (define (f x y) ...)"
               "(define ((f m, k) x) (+ x m))"
               "define: no comma separates arguments: (define ((f m k) x) ...)"
               "(lambda (x, y) (+ x y))" "lambda: no comma separates arguments: (lambda (x y) ...)"
               "(define (f #:k) 3)" "define: a keyword is followed by a name: #:k k"
               "(define (f #:k #:m m) 3)" "define: a keyword is followed by a name: #:k k"
               "(define (f 3) 4)" "define: an argument is a name, which 3 is not"
               "(lambda (\"x\") 4)" "lambda: an argument is a name, which \"x\" is not")])
    (check-equal? (said form) message)))

(test-case "formulas as on paper, and primes"
  (for ([(form message)
         (hash "(define T 1/2 m v^2)"
               "define: operations come first: (define T (* 1/2 m (expt v 2)))"
               "(define (T m v) 1/2 * m * (square v))"
               "define: operations come first: (define (T m v) (* 1/2 m (square v)))"
               "(define (x t) = A*cos(omega*t))"
               "define: a definition is written (define (x t) (* A (cos (* omega t))))"
               "(define ((H m) (up t q p)) p^2/(2m))"
               (string-append "define: operations come first: "
                              "(define ((H m) (up t q p)) (/ (expt p 2) (* 2 m)))")
               "(define m 1.5 kg)"
               (string-append "define: operations come first: (define m (* 1.5 kg)); numbers have "
                              "no units here; any consistent ones will do, as kilograms, meters "
                              "and seconds in (* 5 9.8)")
               "(define x' 3)"
               (string-append "define: a prime is read as a quote; a name is written without, "
                              "as in (define xprime 3)"))])
    (check-equal? (said form) message)))

(test-case "procedures"
  (for ([(form message)
         (hash "(lambda (* 2 t))" "lambda: the arguments come first: (lambda (t) (* 2 t))"
               "(lambda (square x))" "lambda: the arguments come first: (lambda (x) (square x))"
               "(lambda x: (* 2 x))" "lambda: arguments stand in parentheses: (lambda (x) (* 2 x))"
               "(lambda)" "lambda: a function is written (lambda (t) (* 2 t))"
               "(lambda (t))"
               "lambda: no expressions for procedure body; it is written (lambda (t) (* 2 t))")])
    (check-equal? (said form) message)))

(test-case "a keyword without its value"
  (for ([form '("(evolve-trajectory 1 #:tolerance)" "(evolve-trajectory #:tolerance #:events 1)")])
    (check-equal? (said form)
                  "evolve-trajectory: #:tolerance has no value: it stands behind the keyword")))

(test-case "a quote that touches what stands before it"
  (check-equal? (said "(+ 1 2'x)") "+: 2'x is read as two; a product is (* 2 'x)")
  (check-equal? (said "(x' t)") "x: a prime is read as a quote; the derivative of x is (D x)")
  (check-equal? (prints "(list 1 2 'x)" "(list 'a'b)") "'(1 2 x)\n'(a b)\n"))

(test-case "if and cond"
  (check-equal? (said "(cond (else))") "cond: missing expressions in `else' clause"))

(test-case "arguments in a list, where one was meant"
  (define (told form)
    (define port (open-output-string))
    (parameterize ([current-error-port port]) (declare (lines language form)))
    (string-split (get-output-string port) "\n"))
  (define (list-of x)
    (list (format "; f: ~a without parentheses is the list of all arguments; one argument is (~a)"
                  x x)))
  (check-equal? (told "(define f (lambda t (* 2 t)))") (list-of 't))
  (check-equal? (told "(define f (lambda x (list 1 (sin x))))") (list-of 'x))
  (check-equal? (told "(define f (lambda xs (apply + xs)))") '()))
