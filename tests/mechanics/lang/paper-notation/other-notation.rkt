#lang racket/base
;; Names, formulas and signs as other programs and pages of print have them.

(require (for-label mechanics)
         mechanics/lang/unknown-name/other-library
         mechanics/lang/paper-notation/other-notation
         mechanics/lang/unknown-name/suggestion
         (only-in mechanics/lang/paper-notation/prefix-form typed-formula)
         mechanics/lang/paper-notation/typographic
         racket/string
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define ours (exports 'mechanics))

(test-case "no name with an advice is one of the library"
  (for ([name (in-list notation-names)])
    (check-false (memq name ours) (format "~a" name))))

(test-case "each advice names something that the library has"
  (for ([name (in-list notation-names)])
    (define words (regexp-match* #px"[^\\s(),';]+" (notation-sentence name)))
    (check-not-false (for/or ([w (in-list words)])
                       (or (memq (string->symbol w) ours)
                           (member w '("quoted" "#t" "+inf.0"))))
                     (notation-sentence name))))

(define-check (check-suggestion name text)
  (define found (suggestion name ours))
  (unless (equal? found text)
    (with-check-info (['name name] ['expected text] ['found found]) (fail-check))))

(test-case "names of other programs"
  (check-suggestion 'pow "powers are (expt x 2)")
  (check-suggestion 'ln "the natural logarithm is (log x)")
  (check-suggestion 'arctan "its name is atan")
  (check-suggestion 'diff "the derivative of a function f is (D f), a partial one ((partial 0) f)")
  (check-suggestion 'integrate "integrals are (definite-integral f a b)")
  (check-suggestion 'subs "its name is substitute")
  (check-suggestion 'ode45 "motions are computed by evolve-trajectory")
  (check-suggestion 'PI "its name is pi; exactly it is ':pi")
  (check-suggestion 'Γ "its name is Gamma")
  (check-suggestion 'm=2 "a definition is (define m 2); an argument is given by its place, as 2")
  (check-suggestion 'boolean=? "did you mean boolean??")
  (check-suggestion 'simplfy "did you mean simplify?")
  (check-suggestion 'frame "(require mechanics/plot) defines it")
  (check-suggestion 'string-split "(require (only-in racket/string string-split)) defines it")
  (check-suggestion 'flatten "(require (only-in racket/list flatten)) defines it")
  (check-suggestion 'wedge "(require mechanics/geometry) defines it")
  (check-suggestion 'R2-rect "(require mechanics/geometry) defines it")
  (check-suggestion 'define-coordinates "(require mechanics/geometry) defines it")
  (check-suggestion 'e #f)
  (check-suggestion 'range "numbers in a row are (in-range 10), or as a list (iota 10)")
  (check-suggestion 'first
                    "a component is (ref x 0), one of a list (list-ref x 0)")
  (check-suggestion 'import "a library is loaded by (require mechanics/plot)")
  (check-suggestion 'quit "leave with (exit) or Ctrl-D")
  (check-suggestion '? "ask (help), (help verify-solution) or (help \"constraint\")")
  (check-suggestion 'search "ask (help), (help verify-solution) or (help \"constraint\")")
  (check-suggestion 'latex "its name is ->TeX")
  (check-suggestion 'EulerLagrange "its name is Lagrange-equations")
  (check-suggestion '∂L/∂x
                    "a partial derivative of L is ((partial 1) L), a function of the state")
  (check-suggestion ':= "a definition is (define x 3)"))

(test-case "units and degrees"
  (check-suggestion 'degrees "angles are in radians: 30 degrees are (* 30 (/ pi 180))")
  (define units
    (string-append "numbers have no units here; any consistent ones will do, as kilograms, "
                   "meters and seconds in (* 5 9.8)"))
  (check-suggestion 'kg units)
  (check-suggestion 'm/s^2 units))

(test-case "units and degrees behind their numbers"
  (for ([name '(30deg 30° 30degrees)])
    (check-suggestion name "angles are in radians: 30 degrees are (* 30 (/ pi 180))"))
  (check-regexp-match #rx"^write 9.8: numbers have no units here" (suggestion '9.8m/s^2 ours))
  (check-suggestion '2x "operations come first: (* 2 x)"))

(test-case "arguments by name"
  (check-suggestion ':tolerance "a keyword is written #:tolerance")
  (check-suggestion '--tolerance "a keyword is written #:tolerance")
  (check-suggestion
   'm=2 "a definition is (define m 2); an argument is given by its place, as 2"))

(test-case "rates as they are printed"
  (for ([name '(dx/dt x_dot x-dot ẋ)])
    (check-suggestion name "the rate of a path x is (D x), at a time ((D x) 't)"))
  (check-suggestion 'dtheta/dt "the rate of a path theta is (D theta), at a time ((D theta) 't)")
  (check-suggestion (string->symbol "\u03b8\u0307")
                    "the rate of a path θ is (D θ), at a time ((D θ) 't)")
  (check-suggestion 'xdot #f))

(test-case "powers of functions"
  (for ([name '(sin^2 sin²)]) (check-suggestion name "powers come outside: (square (sin x))"))
  (check-suggestion 'cos³ "powers come outside: (cube (cos x))")
  (check-suggestion 'log^4 "powers come outside: (expt (log x) 4)")
  (for ([name '(tan^-1 tan-1)])
    (check-suggestion name "the inverse is (atan x), one over it (/ 1 (tan x))"))
  (check-suggestion 'sin2 "powers come outside: (square (sin x))"))

(test-case "a symbol of that name is told where one may be meant"
  (check-equal? (what-was-meant 'theta ours #f) '("as a symbol it is written 'theta"))
  (check-equal? (what-was-meant 'e ours #f)
                '("as a symbol it is written 'e; the number e is (exp 1)"))
  (check-equal? (what-was-meant 'i ours #f)
                '("as a symbol it is written 'i; the imaginary unit is +i"))
  (check-equal? (what-was-meant 'x² ours #f)
                '("operations come first: (expt x 2)" "a symbol in it is quoted, as 'x"))
  (check-equal? (what-was-meant 'sin² ours #f) '("powers come outside: (square (sin x))"))
  (check-equal? (what-was-meant 'm ours "operations come first: (* m v)")
                '("operations come first: (* m v)" "as a symbol it is written 'm")))

(test-case "formulas as in print"
  (check-suggestion 'x^2 "operations come first: (expt x 2)")
  (check-suggestion '2x "operations come first: (* 2 x)")
  (define (formula text) (typed-formula (string->symbol text)))
  (check-equal? (formula "2*x") '(* 2 x))
  (check-equal? (formula "m*v^2/2") '(/ (* m (expt v 2)) 2))
  (check-equal? (formula "2x^2+1") '(+ (* 2 (expt x 2)) 1))
  (check-equal? (formula "a+b+c") '(+ a b c))
  (check-equal? (formula "1.5t") '(* 1.5 t))
  (check-equal? (formula "2π") '(* 2 pi))
  (check-equal? (formula "x-1") '(- x 1))
  (check-equal? (formula "-x") '(- x))
  (check-equal? (formula "-3x^2") '(- (* 3 (expt x 2))))
  (check-equal? (formula "1/2*m*v^2") '(* 1/2 m (expt v 2))))

(test-case "formulas that have two readings are not offered"
  (check-suggestion 'p^2/2m "operations come first, as in (* 2 x)")
  (check-equal? (what-was-meant 'mv^2/2 ours #f) '("operations come first, as in (* 2 x)")))

(test-case "names that are no formulas"
  (for ([name '(x omega x-dot L-free r1 x_1 theta0 kinetic-energy F->C m:dimension q* + x+
                 ^2 /x x? part-2 - -> -1+)])
    (check-false (typed-formula name) (format "~a" name))))

(test-case "signs of print"
  (define (told text) (typographic-sentence (string->symbol text)))
  (check-equal? (told "’x") "’ in it is a curly quote; type 'x")
  (check-equal? (told "‘x") "‘ in it is a curly quote; type 'x")
  (check-equal? (told "“ab”") "“ in it is a curly quote; type \"ab\"")
  (check-equal? (told "−2") "− in it is a minus of print; type -2")
  (check-equal? (told "F−>C") "− in it is a minus of print; type F->C")
  (check-equal? (told "×") "× in it is a multiplication sign; type *")
  (check-equal? (told "·") "· in it is a multiplication dot; type *")
  (check-false (told "théta"))
  (check-false (told "θ")))

;; ---------------------------------------------------------------------------
;; Where they are told

(define (beneath name . hints)
  (regexp (string-append (regexp-quote name) ": undefined;.*top-level\n"
                         (string-join (map (lambda (h) (regexp-quote (string-append "  " h)))
                                           hints)
                                      "\n"))))

(test-case "at the prompt"
  (define-values (output errors)
    (session '("-I" "mechanics")
             "(arctan 1)" "(* 2 x^2)" "(sin ‘x)" "(- 'x −2)" "(pi * 2)" "(2 * 'x)"))
  (check-equal? output '())
  (check-regexp-match (beneath "arctan" "its name is atan" "as a symbol it is written 'arctan")
                      errors)
  (check-regexp-match (beneath "x^2" "operations come first: (expt x 2)"
                               "a symbol in it is quoted, as 'x")
                      errors)
  (check-regexp-match (beneath "‘x" "‘ in it is a curly quote; type 'x\n") errors)
  (check-regexp-match (beneath "−2" "− in it is a minus of print; type -2\n") errors)
  (check-regexp-match #rx"\npi: operations come first: [(][*] pi 2[)]\n" errors)
  (check-regexp-match #rx"application: operations come first: [(][*] 2 'x[)]" errors))

(test-case "in a module"
  (check-equal? (refusal "(define (f m) (* m v^2))")
                (string-append "example:2:19: v^2: unbound identifier; operations come first: "
                               "(expt v 2); a symbol in it is quoted, as 'v\n  in: v^2"))
  (check-equal? (refusal "(pow 2 3)")
                (string-append "example:2:1: pow: unbound identifier; powers are (expt x 2); "
                               "as a symbol it is written 'pow\n  in: pow"))
  (check-equal? (refusal "(sin ‘x)")
                (string-append "example:2:5: ‘x: unbound identifier; ‘ in it is a curly quote; "
                               "type 'x\n  in: ‘x")))

(test-case "a quoted symbol with a curly quote in its name is one, which is told"
  (define-values (output errors) (session '("-I" "mechanics") "(list 'x’ 'y)" "'z′"))
  (check-equal? output '("'(x’ y)" "z′"))
  (check-equal? errors
                "; 'x’ is a symbol with a curly quote in its name; the symbol x is written 'x\n")
  (define port (open-output-string))
  (parameterize ([current-error-port port]) (declare "#lang mechanics\n(define a 'x’)\n"))
  (check-equal? (get-output-string port) errors))
