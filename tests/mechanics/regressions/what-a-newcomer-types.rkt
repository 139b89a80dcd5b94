#lang racket/base
;; Messages that named no remedy, or the place of a lambda in the library, or
;; another procedure than the one called.

(require mechanics
         (only-in racket/base [expand racket:expand])
         (only-in mechanics/book L-free-particle)
         "../support/checks.rkt" "../support/messages.rkt")

(define L (L-free-particle 'm))
(define x (literal-function 'x))

(test-case "functions of one argument that the library makes are named as they print"
  (for ([f (list (Gamma x) (Gamma x 4) (F->C p->r) (Lagrangian->energy L)
                 (Lagrangian->acceleration L) (Lagrangian->state-derivative L)
                 (Euler-Lagrange-operator L) (Dt L) (component 0)
                 ((Lagrange-equations L) x) ((delta x) L)
                 (make-path 0 1 1 2 '(3)) (make-eta sin 0 1) (principal-value :pi)
                 (Lagrange-interpolation-function '(1 2) (list 0 'a)))])
    (define name (format "~a" (expression f)))
    (check-regexp-match #rx"^[(]" name)
    (for ([arguments '(() (1 2))] [given '("none" "2")])
      (check-message (string-append name ": takes 1 argument; it was given " given)
                     (apply f arguments)
                     exn:fail:contract:arity?))))

(test-case "a path through points prints as one, with its ends"
  (check-equal? (format "~a" (make-path 0 1 't_1 'q_1 '(2 3))) "(path from 0 to t_1)")
  (check-equal? (format "~a" (find-path (L-free-particle 1) 0 1 2 3 1)) "(path from 0 to 2)")
  (check-equal? (format "~a" (Lagrange-interpolation-function '(1 2 3) '(4 6 5)))
                "(Lagrange-interpolation-function from 4 to 5)")
  (check-equal? (format "~a" (make-eta x 0 'tau)) "(make-eta x 0 tau)")
  (check-message "make-path: two points are the same\n  point: 0" (make-path 0 1 0 2 '())))

(test-case "an expression or a number for a path"
  (define hint "a path is written (lambda (t) ...), with t where the time stands")
  (define who
    "verify-solution: a path is a function of time, or a tuple of such functions; given ")
  (check-message (string-append who "(sin t), a number-like expression\n  " hint)
                 (verify-solution L (sin 't)))
  (check-message (string-append who "the number 0\n  " hint) (verify-solution L 0)))

(test-case "substitute shows its use"
  (define usage
    "substitute: expected a value, then each name with its replacement: (substitute x 'm 2 'k 3)\n")
  (check-message (string-append usage "  without a replacement: the symbol m")
                 (substitute (* 'm 'g) 'm))
  (check-message (string-append usage "  without a replacement: the symbol k")
                 (substitute (* 'm 'k) 'm 1 'k))
  (check-message
   "substitute: expected a symbol or an expression to replace\n  given: \"m\", a string"
   (substitute (* 'm 'g) "m" 1))
  (check-message
   "substitute: expected a number or an expression as replacement\n  given: (up 1 2), an up tuple of 2"
   (substitute (* 'm 'g) 'm (up 1 2))))

(test-case "relations as they are written in a text are answered with how they are written here"
  (define (complaint relation) (message-of (assume relation)))
  (check-regexp-match #rx"given: [(]m > 0[)]\n  write: [(]> m 0[)]$" (complaint '(m > 0)))
  (check-regexp-match #rx"\n  write: [(]positive m[)]$" (complaint '(positive? m)))
  (check-regexp-match #rx"\n  several relations are arguments of their own, each quoted$"
                      (complaint '(and (> m 0) (< k 0))))
  (check-regexp-match #rx"given: [(]integer[?] n[)]$" (complaint '(integer? n)))
  (check-equal? (assumptions 'declared) '()))

;; The expander's complaint about a form.
(define-namespace-anchor here)
(define (syntax-complaint form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (message-of (racket:expand form) exn:fail:syntax?)))

(test-case "assuming takes its relations in parentheses, and says so"
  (for ([form '((assuming '(> m 0) (sqrt (square 'm)))
                (assuming (> m 0) (sqrt (square 'm)))
                (assuming (> 'm 0) (sqrt (square 'm))))])
    (check-regexp-match
     #rx"^assuming: relations stand in parentheses: [(]assuming [(]'[(]> m 0[)][)] body[)]"
     (syntax-complaint form)))
  (for ([form '((assuming (m > 0) (sqrt (square 'm))) (assuming ('m > 0) (sqrt (square 'm))))])
    (check-regexp-match #rx"relations stand in parentheses: [(]assuming [(]'[(]> m 0[)][)] body[)]"
                        (syntax-complaint form)))
  (check-regexp-match #rx"stand in parentheses: [(]assuming [(]'[(]> m 0[)] '[(]> k 0[)][)] body[)]"
                      (syntax-complaint '(assuming '((> m 0) (k > 0)) 'm)))
  (check-regexp-match #rx"expected relations in parentheses, then a body"
                      (syntax-complaint '(assuming 'm (sqrt (square 'm)))))
  (define relation '(> m 0))
  (check-equal? (assuming (relation) (simplify (sqrt (square 'm)))) 'm)
  (check-equal? (assuming () 3) 3))

(test-case "the relation to write has no quotes within"
  (check-regexp-match #rx"a relation is quoted here: write '[(]> m 0[)]"
                      (syntax-complaint '(assume (> 'm 0))))
  (check-regexp-match #rx"a relation is quoted here: write '[(]> m 0[)]"
                      (syntax-complaint '(assume ('m > 0)))))

(test-case "series:print speaks for itself"
  (check-exn
   #rx"^series:print: the series does not end; say of how many terms: [(]series:print s n[)]"
   (lambda () (series:print ((Taylor-series sin) 'x))))
  (check-exn #rx"^series:print: expected a series" (lambda () (series:print 5))))

(test-case "the rows of a matrix are arguments"
  (check-message
   "matrix-by-rows: each list is an argument of its own: (matrix-by-rows '(1 2) '(3 4))\n  given: '((1 2) (3 4))"
   (matrix-by-rows '((1 2) (3 4))))
  (check-exn #rx"[(]matrix-by-columns '[(]1 2[)] '[(]3 4[)][)]"
             (lambda () (matrix-by-columns '((1 2) (3 4))))))

(test-case "a dot among the components of a tuple"
  (for ([name '(up down)])
    (check-regexp-match (format "^~a: the components are separated by spaces, without a dot" name)
                        (syntax-complaint (list* name 1 2 3)))))
