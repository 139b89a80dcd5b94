#lang racket/base
;; Functions as values: arity and printing.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/function
         mechanics/generic/up-down
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         "../support/checks.rkt")

(define (printed x) (format "~s" x))

;; ---------------------------------------------------------------------------
;; Arity

(test-case "arity masks of functions of every kind"
  (check-equal? (arity-mask sin) 2)
  (check-equal? (arity-mask (lambda (x [y 1]) x)) 6)
  (check-equal? (arity-mask list) -1)
  (check-equal? (arity-mask (literal-function 'f)) 2)
  (check-equal? (arity-mask (literal-function 'f (-> (X Real Real) Real))) 4)
  (check-equal? (arity-mask (D (lambda (x y) x))) 4)
  (check-equal? (arity-mask (g:sin (lambda (x y z) x))) 8)
  (check-equal? (arity-mask (up sin (lambda (x [y 1]) x))) 2)
  (check-equal? (arity-mask 3) -1))

(test-case "arity in words"
  (define (words f) (arity->text f))
  (check-equal? (words sin) "1 argument")
  (check-equal? (words (lambda (x y) x)) "2 arguments")
  (check-equal? (words (lambda (x [y 1]) x)) "1 or 2 arguments")
  (check-equal? (words (lambda (x [y 1] [z 2]) x)) "1 to 3 arguments")
  (check-equal? (words (lambda (x . more) x)) "at least 1 argument")
  (check-equal? (words (g:+ (lambda (x) x) (lambda (x y) x))) "no number of arguments"))

(test-case "accepts? asks for one number of arguments"
  (check-true (accepts? (lambda (x y) x) 2))
  (check-false (accepts? (lambda (x y) x) 1))
  (check-true (accepts? list 17)))

(test-case "pointwise? tells functions from operators, tuples and data"
  (for ([f (list sin (lambda (x) x) (literal-function 'f) (g:+ sin cos) (D sin))])
    (check-true (pointwise? f)))
  (for ([x (list D (up sin cos) 'a 3)])
    (check-false (pointwise? x))))

;; ---------------------------------------------------------------------------
;; Printing

(define V (literal-function 'V))
(define (speed t) t)

(test-case "a combination of functions prints as what was typed"
  (check-equal? (printed (g:+ V speed)) "(+ V speed)")
  (check-equal? (printed (g:* 1/2 'm (g:square V))) "(* (* 1/2 m) (square V))")
  (check-equal? (printed (g:sqrt (g:- g:sin speed))) "(sqrt (- sin speed))")
  (check-equal? (printed (g:* (up 'a 2) V)) "(* (up a 2) V)"))

(test-case "an anonymous function prints as such, without its place in a file"
  (check-equal? (printed (g:+ V (lambda (x) x))) "(+ V <function>)"))

(test-case "combinations print alike in all three modes"
  (define f (g:/ V (g:exp speed)))
  (check-equal? (format "~a" f) (printed f))
  (check-equal? (format "~v" f) (printed f))
  (check-equal? (format "~v" (list f)) "(list (/ V (exp speed)))"))
