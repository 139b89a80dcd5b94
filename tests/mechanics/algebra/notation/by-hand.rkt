#lang racket/base
;; Formulas as a strict reader would write them by hand: parentheses where they must be, and
;; no others.

(require mechanics/algebra/notation/formula
         mechanics/algebra/notation/formula-style
         mechanics/algebra/notation/infix
         mechanics/algebra/notation/read-infix
         (only-in mechanics/show/typesetting/TeX tree->TeX)
         "../../support/checks.rkt")

(define (infix d) (tree->line (datum->tree d (current-way #f #t))))
(define (TeX d) (tree->TeX (datum->tree d (current-way #t #t))))
(define (as-written d) (tree->line (datum->tree d (current-way #f #f))))

(define-syntax-rule (lines write [datum text] ...)
  (begin (test-case text (check-equal? (write 'datum) text)) ...))

(lines infix
  [(- (+ a b)) "−(a + b)"] [(* (+ a) b) "a b"] [(- a (- b)) "a + b"] [(- a (+ b c)) "a − (b + c)"]
  [(* a (- b)) "−a b"] [(* (- x) (- y)) "x y"] [(- -2) "2"] [(* 2 3) "2 (3)"]
  [(+ (* -1 (+ a b)) c) "−(a + b) + c"] [(* -3/2 x) "−(3/2) x"] [(* 2 (expt 3 x)) "2 (3^(x))"]
  [(* r x :pi 2) "2 π r x"])

(lines infix
  [(/ a (/ b c)) "a/(b/c)"] [(/ (/ a b) c) "(a/b)/c"] [(/ a (- b)) "−a/b"]
  [(/ (- a) (- b)) "a/b"] [(/ 1 (* a b)) "1/(a b)"] [(* 1/2 a (/ 1 b)) "a/(2 b)"]
  [(/ 7/11 x) "7/(11 x)"] [(/ (sin x) y) "sin(x)/y"] [(/ (+ a b) (* 2 c)) "(a + b)/(2 c)"])

(lines infix
  [(expt -2 n) "(−2)^(n)"] [(expt (- x) 2) "(−x)²"] [(expt (/ a b) 2) "(a/b)²"]
  [(expt 1/2 n) "(½)^(n)"] [(expt x -2) "1/x²"] [(expt x -1/2) "1/x^(1/2)"]
  [(expt x (* -1 n)) "1/x^(n)"] [(expt x (- n 1)) "x^(n − 1)"]
  [(expt (expt x y) z) "(x^(y))^(z)"] [(expt x (expt y z)) "x^(y^(z))"]
  [(expt (sqrt a) 3) "(√a)³"] [(expt x^2 2) "(x^2)²"] [(expt -1.5 2) "(−1.5)²"]
  [(expt 1e-30 2) "(1×10⁻³⁰)²"] [(sqrt (/ a b)) "√(a/b)"] [(/ 1 (sqrt 2)) "1/√2"])

(lines infix
  [(expt (sin x) 2) "sin² x"] [(expt (sin x) -1) "1/sin(x)"] [(expt (sin x) n) "(sin x)^(n)"]
  [(expt (expt (sin x) 2) 2) "(sin² x)²"] [(expt (sin (* 2 x)) 2) "sin²(2 x)"]
  [(sin (- x)) "sin(−x)"] [(atan y x) "atan(y, x)"] [(atan (/ y x)) "atan(y/x)"]
  [(expt (abs x) 3) "abs(x)³"] [(expt (exp x) 2) "(exp(x))²"] [(+ (sin x) y) "sin x + y"]
  [(* (sin x) (cos y)) "sin x cos y"] [(* (sin x) 2 y) "2 y sin x"]
  [(* (sin x) (f x)) "f(x) sin x"] [(* (sin x) (up a b)) "sin(x) up(a, b)"])

;; A factor that a function would seem to hold stands behind it where order is kept.
(lines as-written
  [(* (sin x) y) "sin(x) y"] [(* (sin x) (cos y) z) "sin x cos(y) z"]
  [(* (expt (sin x) 2) y) "sin²(x) y"])

(lines infix
  [(expt ((D x) t) 2) "(Dx(t))²"] [(expt ((D x) t) n) "(Dx(t))^(n)"]
  [(expt (((partial 1) F) x y) 2) "(∂₁F(x, y))²"] [((D (f a)) s) "D(f(a))(s)"]
  [(((D f) a) s) "Df(a)(s)"] [((D f) (g t)) "Df(g(t))"] [((D (compose f g)) t) "D(f ∘ g)(t)"]
  [((D (* f g)) t) "D(f g)(t)"] [((D (D x)) t) "DDx(t)"]
  [(((partial 1 0) f) (up t (up x y))) "∂_(1,0)f(up(t, up(x, y)))"]
  [(partial 0) "∂₀"] [(expt (partial 1) 2) "(∂₁)²"])

(test-case "a name with a letter that nobody sees shows it, and is read back"
  (define s (string->symbol "a\u200bb"))
  (check-equal? (infix s) "|a\\u200b;b|")
  (check-eq? (infix->datum (infix s)) s))

(test-case "the derivative of what a function gives is read back as that"
  (check-equal? (infix->datum (infix '((D (f a)) s))) '((D (f a)) s)))

;; Dots stand over the letter, not over what stands below it.
(lines TeX
  [(/ (* -1 (+ a b)) c) "-\\frac{a + b}{c}"] [(/ a (* -1 (+ b c))) "-\\frac{a}{b + c}"]
  [(/ (- (+ a b)) (- (+ c d))) "\\frac{a + b}{c + d}"])

;; Brackets stretch by what they hold, not by how it is spelled.
(lines TeX
  [(* m (+ g xdotdot)) "m\\,(g + \\ddot{x})"]
  [(* m (+ left frac)) "m\\,(\\mathit{left} + \\mathit{frac})"]
  [(* m (+ g (/ a b))) "m\\,\\left(g + \\frac{a}{b}\\right)"])

(lines TeX
  [((D p_x) t) "\\dot{p}_{x}(t)"] [(((expt D 2) theta_1) t) "\\ddot{\\theta}_{1}(t)"]
  [(expt ((D f) x) 2) "(D f(x))^{2}"] [(expt (/ a b) 2) "\\left(\\frac{a}{b}\\right)^{2}"])

(test-case "names with something above, dotted, are raised to powers in parentheses"
  (parameterize ([suppress-arguments '(t)] [derivative-style 'dots])
    (check-equal? (infix '((D p_x) t)) "ṗₓ")
    (check-equal? (infix '(expt ((D v^x) t) 2)) "(v̇^x)²")
    (check-equal? (TeX '(expt ((D v^x) t) 2)) "(\\dot{v}^{x})^{2}")))
