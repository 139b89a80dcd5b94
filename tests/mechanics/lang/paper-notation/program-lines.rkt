#lang racket/base
;; Lines of a program that were meant as one form.

(require "../../support/checks.rkt" "../../support/run-text.rkt")

(define (said text in) (string-append "example:" text "\n  in: " in))

(test-case "a formula, a definition, a call as on paper"
  (check-equal? (refusal "m = 3") (said "2:0: line: a definition is written (define m 3)" "m"))
  (check-equal? (refusal "(define k 2)" "E = k m h")
                (said "3:0: line: a definition is written (define E (* k 'm 'h))" "E"))
  (check-equal? (refusal "L = 1/2 m v^2")
                (said (string-append "2:0: line: a Lagrangian is a function of (up t q v): "
                                     "(define ((L m) (up t q v)) (* 1/2 m (expt v 2)))")
                      "L"))
  (check-equal? (refusal "(define (f x) x)" "f(3)") (said "3:0: line: f(3) is written (f 3)" "f"))
  (check-equal? (refusal "2 + 3") "example:2:0: line: operations come first: (+ 2 3)\n  in: 2"))

(test-case "Mathematica's and Python's ways"
  (check-equal? (refusal "D[Sin[x],x]")
                (said (string-append "2:0: line: a derivative is that of a function: "
                                     "((D (lambda (x) (sin x))) 'x)")
                      "D"))
  (check-equal? (refusal "Sin[x]") (said "2:0: line: a call stands in parentheses: (sin x)" "Sin"))
  (check-equal? (refusal "lambda x: x**2")
                (said "2:0: line: a function is written (lambda (x) (expt x 2))" "lambda"))
  (check-equal? (refusal "(map (lambda x: x**2) (list 1))")
                (string-append "example:2:5: lambda: arguments stand in parentheses: "
                               "(lambda (x) (expt x 2))\n  in: (lambda x: x**2)"))
  (check-equal? (refusal "(Sin 'x)")
                (string-append "example:2:1: Sin: unbound identifier; its name is sin; "
                               "as a symbol it is written 'Sin\n  in: Sin"))
  (check-equal? (refusal "(->tex-equation 'x)")
                (string-append "example:2:1: ->tex-equation: unbound identifier; "
                               "its name is ->TeX; as a symbol it is written '->tex-equation\n  in: ->tex-equation")))

(test-case "a formula that is not read is not translated"
  (check-equal? (refusal "(define y 1/2 * m * v^2/2k)")
                (string-append "example:2:0: define: operations come first, as in (* 2 x)\n"
                               "  in: (define y 1/2 * m * v^2/2k)"))
  (check-equal? (refusal "(* 2 k*|x|)")
                (string-append "example:2:5: k*x: unbound identifier; operations come first, "
                               "as in (* 2 x); a symbol in it is quoted, as 'k\n  in: k*x")))

(test-case "what was pasted with the prompt, or was printed"
  (check-equal? (refusal "> (+ 1 2)")
                (said "2:0: line: > is the prompt's, not part of what is typed: (+ 1 2)" ">"))
  (check-equal? (refusal "'a" "proved: the residual is zero")
                (said "3:0: line: proved: ... is a line that was printed, nothing to type"
                      "proved:")))

(test-case "a body of several forms may be meant"
  (check-equal? (prints "(define (f x) x (list x))" "(f 3)") "'(3)\n"))

(test-case "several forms of a line may be meant"
  (check-equal? (prints "(define a 1) (define b 2)" "a b (+ a b)" "'x 'y") "1\n2\n3\nx\ny\n"))
