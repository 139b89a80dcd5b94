#lang racket/base
;; Names that other programs and books have for names of ours.  Letters of physics (e, i, N) are
;; left out: mostly they are meant for symbols.  Names such as dx/dt, too many to list, are known
;; by their pattern.

(provide notation-names notation-sentence)

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
    ("its name is tan" tg)
    ("its name is cot" ctg cotan)
    ("its name is csc" cosec)
    ("its name is sqrt" Sqrt root)
    ("powers are (expt x 1/3)" cbrt)
    ("its name is abs" fabs)
    ("its name is ceiling" ceil)
    ("its name is modulo" mod)
    ("the derivative of a function f is (D f), a partial one ((partial 0) f)"
     diff deriv differentiate d/dt d/dx d/dq ddt Dt-of Diff pdiff)
    ("its name is gradient" grad nabla)
    ("integrals are (definite-integral f a b)" integrate integral int Int quad)
    ("a sum over i is (for/sum ([i 10]) (f i))" sum Sum)
    ("its name is for/product" prod Prod)
    ("its name is determinant" det Det)
    ("its name is invert" inv Inverse)
    ("its name is dot-product" dot)
    ("its name is cross-product" cross)
    ("its name is euclidean-norm" norm)
    ("tuples are (up x y ...)" vec Vector tuple array Array)
    ("its name is steady-precessions" steady-precession)
    ("its name is substitute" subs subst replace-all)
    ("its name is exact->inexact" evalf float)
    ("roots are found by (find-root f low high), linear systems solved by solve-linear-left"
     solve fsolve Solve nsolve)
    ("motions are computed by evolve-trajectory"
     odeint ode45 ode solve_ivp dsolve NDSolve DSolve integrate-motion)
    ("a symbol is quoted, as 'x, and needs no declaration" symbols Symbol syms var)
    ("its name is pi; exactly it is ':pi" PI Pi π)
    ("its name is Gamma" Γ)
    ("infinity is +inf.0" inf Inf infinity Infinity oo ∞)
    ("the true value is #t, the false one #f" true false True False)
    ("a definition is (define (f x) ...)" def defun function)
    ("a function without a name is (lambda (x) ...)" fn fun)
    (,about-degrees deg degree degrees :degree °)
    (,about-units
     kg meter meters metre metres newton newtons joule joules m/s m/s^2 m/s² m/s/s rad/s)
    ("a library is loaded by (require mechanics/plot)" import from using)
    ("numbers in a row are (in-range 10), or as a list (iota 10)" range linspace arange)
    ("a component is (ref x 0), one of a list (list-ref x 0)" first second third nth getitem)
    ("what is typed is printed; in a program, (print-expression x) prints" disp puts)
    ("leave with (exit) or Ctrl-D" quit bye)
    ("ask (help), (help verify-solution) or (help \"constraint\")" ? ?? man info apropos doc)
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

;; -> text or #f
(define (notation-sentence name)
  (or (hash-ref advice-of name #f)
      (let ([text (symbol->string name)])
        (for/or ([sentence (in-list patterns)]) (sentence text)))))

;; ---------------------------------------------------------------------------
;; Patterns

;; dx/dt, x_dot, x-dot, ẋ in one character or two
(define (sentence-about-rate text)
  (define found
    (or (regexp-match #px"^d((?:\\p{L}|[_0-9])+)/dt$" text)
        (regexp-match #px"^(\\p{L}+)[-_]dot$" text)
        (regexp-match #px"^(\\p{L})\u307$" (string-normalize-nfd text))))
  (and found
       (format "the rate of a path ~a is (D ~a), at a time ((D ~a) 't)"
               (cadr found) (cadr found) (cadr found))))

;; sin^2, sin², sin^-1, sin-1
(define (sentence-about-power text)
  (define found
    (or (regexp-match #px"^(a?(?:sin|cos|tan)h?|exp|log|sqrt)(?:\\^(-?[0-9]+)|([²³]))$" text)
        (regexp-match #px"^((?:sin|cos|tan)h?)(-1|[2-9])()$" text)))
  (and found
       (let ([name (cadr found)] [power (or (caddr found) (cadddr found))])
         (cond [(member power '("2" "²")) (format "powers come outside: (square (~a x))" name)]
               [(member power '("3" "³")) (format "powers come outside: (cube (~a x))" name)]
               [(equal? power "-1") (format "the inverse is (a~a x), one over it (/ 1 (~a x))"
                                             name name)]
               [else (format "powers come outside: (expt (~a x) ~a)" name power)]))))

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

;; :tolerance 1e-9 and m=2, as other programs name arguments
(define (sentence-about-argument text)
  (cond [(regexp-match #px"^:(\\p{L}(?:\\p{L}|-)*)$|^--(\\p{L}(?:\\p{L}|-)*)$" text)
         => (lambda (found) (format "a keyword is written #:~a" (or (cadr found) (caddr found))))]
        [(regexp-match #px"^(\\p{L}(?:\\p{L}|[0-9_-])*)=([^?].*)$" text)
         => (lambda (found)
              (format "a definition is (define ~a ~a); an argument is given by its place, as ~a"
                      (cadr found) (caddr found) (caddr found)))]
        [else #f]))

(define patterns
  (list sentence-about-rate sentence-about-power sentence-about-unit sentence-about-argument))
