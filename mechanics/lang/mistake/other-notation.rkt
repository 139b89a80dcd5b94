#lang racket/base
;; Names that other programs, and books, have for what is called otherwise here.  Letters of
;; physics (e, i, N) are left out: who writes one means a symbol.

(provide notation-names notation-sentence)

;; (advice name ...) ...
(define notations
  '(("powers are (expt x 2)" pow power ** raise-to)
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
    ("tuples are (up x y ...)" vec Vector tuple)
    ("its name is substitute" subs subst replace-all)
    ("its name is exact->inexact" evalf float)
    ("roots are found by (find-root f low high), linear systems solved by solve-linear-left"
     solve fsolve Solve nsolve)
    ("motions are computed by evolve-trajectory"
     odeint ode45 ode solve_ivp dsolve NDSolve DSolve integrate-motion)
    ("a symbol is quoted, as 'x, and needs no declaration" symbols Symbol syms var)
    ("its name is pi; exactly it is ':pi" PI Pi π)
    ("infinity is +inf.0" inf Inf infinity Infinity oo ∞)
    ("the true value is #t, the false one #f" true false True False)
    ("a definition is (define (f x) ...)" def defun function)
    ("a function without a name is (lambda (x) ...)" fn fun)))

(define advice-of
  (for*/hasheq ([entry (in-list notations)] [name (in-list (cdr entry))])
    (values name (car entry))))

(define notation-names (hash-keys advice-of))

;; -> text or #f
(define (notation-sentence name) (hash-ref advice-of name #f))
