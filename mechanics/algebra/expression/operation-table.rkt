#lang racket/base
;; The table of operations: all there is to say of each, in one entry.
;;
;;     [name (argument ...) numeric domain partial ...]
;;
;; numeric is the operation on numbers.  Each argument has a partial derivative,
;; an expression in the arguments and in `value`, the operation's value there
;; (so that exp and sqrt share the node they are made of); `(slope a b)` is the
;; quotient a/b, or the complaint that there is no derivative where b vanishes; and `(pole a)`
;; is a, of an operation that has no value at some arguments.
;; domain lists, for each argument, an interval on which the operation is real
;; and smooth: there every derivative is tested.
;;
;; An entry is data until a floor makes something of it.  This floor takes names
;; and numeric bodies for the heads of expressions; the derivatives are written
;; in the generic arithmetic of the floor above, which makes procedures of them.

(require (for-syntax racket/base)
         "numeric-functions.rkt")

(provide (for-syntax operation-entries find-entry))

(begin-for-syntax
  (define operation-entries
    (syntax->list
     #'([+ (a b) + ((-2.0 2.0) (-2.0 2.0)) 1 1]
        [- (a b) - ((-2.0 2.0) (-2.0 2.0)) 1 -1]
        [* (a b) * ((-2.0 2.0) (-2.0 2.0)) b a]
        [/ (a b) / ((-2.0 2.0) (0.3 2.0)) (g:/ 1 b) (pole (g:negate (g:/ value b)))]

        [expt (b n) expt ((0.7 2.0) (-3.0 3.0)) (power-by-base b n) (power-by-exponent b n value)]
        [sqrt (x) sqrt ((0.2 5.0)) (slope 1 (g:* 2 value))]
        [exp (x) exp ((-2.0 2.0)) value]
        [log (x) log ((0.2 5.0)) (slope 1 x)]

        [sin (x) sin ((-4.0 4.0)) (g:cos x)]
        [cos (x) cos ((-4.0 4.0)) (g:negate (g:sin x))]
        [tan (x) tan ((-1.2 1.2)) (pole (g:+ 1 (g:square value)))]
        [asin (x) asin ((-0.9 0.9)) (slope 1 (g:sqrt (g:- 1 (g:square x))))]
        [acos (x) acos ((-0.9 0.9)) (slope -1 (g:sqrt (g:- 1 (g:square x))))]
        [atan (y) atan ((-3.0 3.0)) (slope 1 (g:+ 1 (g:square y)))]
        [atan (y x) atan ((0.2 2.0) (-2.0 2.0))
              (slope x (g:+ (g:square x) (g:square y)))
              (slope (g:negate y) (g:+ (g:square x) (g:square y)))]

        [sinh (x) sinh ((-3.0 3.0)) (g:cosh x)]
        [cosh (x) cosh ((-3.0 3.0)) (g:sinh x)]
        [tanh (x) tanh ((-3.0 3.0)) (g:- 1 (g:square value))]
        [asinh (x) asinh ((-3.0 3.0)) (slope 1 (g:sqrt (g:+ (g:square x) 1)))]
        [acosh (x) acosh ((1.1 4.0)) (slope 1 (g:* (g:sqrt (g:- x 1)) (g:sqrt (g:+ x 1))))]
        [atanh (x) atanh ((-0.8 0.8)) (slope 1 (g:- 1 (g:square x)))]

        [abs (x) modulus ((-2.0 -0.1)) (slope x (real-value 'abs value x))]
        [sgn (x) sgn ((-2.0 -0.1)) (slope 0 (real-value 'sgn value x))])))

  ;; What is made of other operations and heads no expressions, with an expression in
  ;; the place of the numeric operation.
  (define composite-entries
    (syntax->list
     #'([square (a) (g:* a a) ((-2.0 2.0)) (g:* 2 a)]
        [cube (a) (g:* a (g:square a)) ((-2.0 2.0)) (g:* 3 (g:square a))]
        [negate (a) (g:negate a) ((-2.0 2.0)) -1]
        [exact->inexact (x) x ((-2.0 2.0)) 1])))

  ;; The entry of that name and number of arguments.
  (define (find-entry name arity)
    (or (for/first ([e (in-list (append operation-entries composite-entries))]
                    #:when (syntax-case e ()
                             [(n args . _)
                              (and (eq? (syntax-e #'n) name)
                                   (= (length (syntax->list #'args)) arity))]))
          e)
        (raise-syntax-error #f "no such operation in the table" name))))
