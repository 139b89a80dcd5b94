#lang racket/base
;; Names that other programs and books have for names of ours.  Letters of physics (e, i, N) are
;; left out: mostly they are meant for symbols.  Names such as dx/dt, too many to list, are known
;; by their pattern.

(provide notation-names notation-sentence foreign-name?)

(define about-degrees "angles are in radians: 30 degrees are (* 30 (/ pi 180))")
(define about-units
  (string-append "numbers have no units here; any consistent ones will do, as kilograms, "
                 "meters and seconds in (* 5 9.8)"))

;; (advice name ...) ...
(define notations
  `(("powers are (expt x 2)" pow power ** raise-to)
    ("the natural logarithm is (log x)" ln Log)
    ("to another base it is (log x 10)" log10 log2 lg)
    ("its name is asin" arcsin Arcsin ArcSin arc-sin)
    ("its name is acos" arccos Arccos ArcCos arc-cos)
    ("its name is atan" arctan Arctan ArcTan arc-tan arctg)
    ("the angle of the point (x, y) is (atan y x)" atan2 arctan2)
    ("its name is asinh" arcsinh arsinh ArcSinh)
    ("its name is acosh" arccosh arcosh ArcCosh)
    ("its name is atanh" arctanh artanh ArcTanh)
    ("its name is sin" Sin)
    ("its name is cos" Cos)
    ("its name is tan" Tan tg)
    ("its name is exp" Exp)
    ("its name is cot" ctg cotan)
    ("its name is csc" cosec)
    ("its name is sqrt" Sqrt root)
    ("powers are (expt x 1/3)" cbrt)
    ("its name is abs" Abs fabs)
    ("its name is ceiling" ceil)
    ("its name is modulo" mod)
    ("the derivative of a function f is (D f), a partial one ((partial 0) f)"
     diff deriv differentiate d/dt d/dx d/dq ddt Dt-of Diff pdiff ∂)
    ("its name is gradient" grad nabla)
    ("integrals are (definite-integral f a b)" integrate integral int Int Integrate NIntegrate quad
     ∫)
    ("a sum over i is (for/sum ([i 10]) (f i))" sum Sum)
    ("its name is for/product" prod Prod)
    ("its name is determinant" det Det)
    ("its name is invert" inv Inverse)
    ("its name is dot-product" dot)
    ("its name is cross-product" cross)
    ("its name is euclidean-norm" norm)
    ("its name is literal-function" literal-fn Function)
    ("its name is Lagrange-equations" EulerLagrange EulerEquations euler_equations LagrangesMethod)
    ("a series cut off is (series:head s n), its terms are shown by series:print" series->list)
    ("a picture is written by (graphics-save f \"picture.png\"), after (require mechanics/plot)"
     save savefig save-picture export-plot)
    ("tuples are (up x y ...)" vec Vector tuple array Array)
    ("its name is steady-precessions" steady-precession)
    ("its name is substitute" subs subst replace-all)
    ("its name is exact->inexact" evalf float)
    ("roots are found by (find-root f low high), linear systems solved by solve-linear-left"
     solve fsolve Solve NSolve FindRoot nsolve)
    ("motions are computed by evolve-trajectory"
     odeint ode45 ode solve_ivp dsolve NDSolve DSolve integrate-motion)
    ("a symbol is quoted, as 'x, and needs no declaration" symbols Symbol syms var)
    ("its name is pi; exactly it is ':pi" PI Pi π)
    ("its name is Gamma" Γ)
    ("its name is ->TeX" ->tex-equation ->tex ->latex latex tex TeX)
    ("a formula as on paper is read by (read-infix \"½ m v²\")" parse-TeX read-TeX parse sympify)
    ("its name is simplify" Simplify FullSimplify)
    ("infinity is +inf.0" inf Inf infinity Infinity oo ∞ :infinity :+infinity +infinity)
    ("infinity is +inf.0, its opposite -inf.0" -inf -infinity -Infinity -oo -∞ :-infinity)
    ("the true value is #t, the false one #f" true false True False)
    ("a definition is (define (f x) ...)" def defn defun function)
    ("a function without a name is (lambda (x) ...)" fn fun)
    (,about-degrees deg degree degrees :degree °)
    (,about-units
     kg meter meters metre metres newton newtons joule joules m/s m/s^2 m/s² m/s/s rad/s)
    ("a library is loaded by (require mechanics/plot)" import from using include)
    ("numbers in a row are (in-range 10), or as a list (iota 10)" range linspace arange)
    ("a component is (ref x 0), one of a list (list-ref x 0)" first second third nth getitem)
    ("what is typed is printed; in a program, (print-expression x) prints" disp puts)
    ("leave with (exit) or Ctrl-D" quit bye)
    ("ask (help), (help verify-solution) or (help \"constraint\")" ? ?? man info apropos doc
     search search-help lookup)
    ("a definition is (define x 3)" := ≔ <-)
    ("what is not equal is (not (= a b))" != ≠ /= <>)
    ("what is repeated is (for ([i 10]) ...), or a function that calls itself" while loop repeat)
    ("the value of a function is that of its last expression" return)
    ("after (require rackunit) there are checks: (check-true (= a b))"
     check-equal? check-true check-false check-= check-within test-case assert)
    ("the empty list is '()" nil None)
    ("curves are drawn by plot-function, after (require mechanics/plot)" plot Plot draw)))

(define advice-of
  (for*/hasheq ([entry (in-list notations)] [name (in-list (cdr entry))])
    (values name (car entry))))

(define notation-names (hash-keys advice-of))
(define (foreign-name? name) (hash-has-key? advice-of name))

;; -> text or #f
(define (notation-sentence name)
  (or (hash-ref advice-of name #f)
      (let ([text (symbol->string name)])
        (or (sentence-by-pattern text)
            (sentence-by-pattern (string-normalize-nfd text))
            (sentence-about-unit text)))))

;; ---------------------------------------------------------------------------
;; Patterns

(define about-rate "the rate of a path \\1 is (D \\1), at a time ((D \\1) 't)")

;; (pattern sentence) ...; the first pattern that fits holds
(define patterns
  `(;; dx/dt, x_dot, x-dot, ẋ in two characters
    (#px"^∂(?:\\p{L}|[_0-9])*/∂(?:\\p{L}|[_0-9])+$"
     "a partial derivative of L is ((partial 1) L), a function of the state")
    (#px"^d((?:\\p{L}|[_0-9])+)/dt$" ,about-rate)
    (#px"^(\\p{L}+)[-_]dot$" ,about-rate)
    (#px"^(\\p{L})\u307$" ,about-rate)
    ;; sin2, sin^2, sin², sin-1, sin^-1
    (#px"^((?:sin|cos|tan)h?)2$" "powers come outside: (square (\\1 x))")
    (#px"^((?:sin|cos|tan)h?)3$" "powers come outside: (cube (\\1 x))")
    (#px"^((?:sin|cos|tan)h?)-1$" "the inverse is (a\\1 x), one over it (/ 1 (\\1 x))")
    (#px"^((?:sin|cos|tan)h?)([4-9])$" "powers come outside: (expt (\\1 x) \\2)")
    (#px"^(a?(?:sin|cos|tan)h?|exp|log|sqrt)(?:\\^2|²)$" "powers come outside: (square (\\1 x))")
    (#px"^(a?(?:sin|cos|tan)h?|exp|log|sqrt)(?:\\^3|³)$" "powers come outside: (cube (\\1 x))")
    (#px"^(a?(?:sin|cos|tan)h?|exp|log|sqrt)\\^-1$"
     "the inverse is (a\\1 x), one over it (/ 1 (\\1 x))")
    (#px"^(a?(?:sin|cos|tan)h?|exp|log|sqrt)\\^(-?[0-9]+)$"
     "powers come outside: (expt (\\1 x) \\2)")
    ;; :tolerance 1e-9 and m=2, as other programs name arguments
    (#px"^(?::|--)(\\p{L}(?:\\p{L}|-)*)$" "a keyword is written #:\\1")
    (#px"^(\\p{L}(?:\\p{L}|[0-9_-])*)=([^?].*)$"
     "a definition is (define \\1 \\2); an argument is given by its place, as \\2")))

(define (sentence-by-pattern text)
  (define found (findf (lambda (p) (regexp-match? (car p) text)) patterns))
  (and found (regexp-replace (car found) text (cadr found))))

;; 30deg, 30°, and 9.8m/s^2
(define (sentence-about-unit text)
  (define found (regexp-match #px"^([0-9.]+)(.+)$" text))
  (define number (and found (string->number (cadr found)) (cadr found)))
  (define advice (and number (hash-ref advice-of (string->symbol (caddr found)) #f)))
  (cond [(not advice) #f]
        [(eq? advice about-degrees)
         (format "angles are in radians: ~a degrees are (* ~a (/ pi 180))" number number)]
        [(eq? advice about-units) (format "write ~a: ~a" number about-units)]
        [else #f]))
