#lang racket/base
;; Application: what is no function explains itself, and what is one is applied
;; as if by Racket.

(require (only-in mechanics/generic/arithmetic g:+ g:* g:-)
         (only-in mechanics/generic/compare g:=)
         (only-in mechanics/value/matrix/quotient quotient-of)
         mechanics/lang/application
         mechanics/lang/pattern/pattern
         "../support/checks.rkt" "../support/messages.rkt")

(define-namespace-anchor here)
(define (expanded form)
  (parameterize ([current-namespace (namespace-anchor->namespace here)])
    (syntax->datum (expand form))))

(define (mentions? name datum)
  (if (pair? datum)
      (or (mentions? name (car datum)) (mentions? name (cdr datum)))
      (eq? name datum)))

;; ---------------------------------------------------------------------------
;; Values that are no functions

(define three 3)
(define x 'x)
(define pair '(1 2))

(test-case "a number says that it is one, under the name that holds it"
  (check-equal? (message-of (three 't))
                "three: the value 3 is a number; it cannot be applied to the argument t")
  (check-equal? (message-of (three))
                "three: the value 3 is a number; it cannot be applied to no arguments")
  (check-equal? (message-of (three 1 (up 'a 2)))
                "three: the value 3 is a number; it cannot be applied to the arguments 1 (up a 2)"))

(test-case "an operator without a name is an application"
  (check-equal? (message-of (3 't))
                (string-append "application: the value 3 is a number; it cannot be applied to the "
                               "argument t; a product is (* 3 't)"))
  (check-equal? (message-of ((values 3) 't))
                (string-append "application: the value 3 is a number; it cannot be applied to the "
                               "argument t; a product is (* 3 't)"))
  (check-equal? (message-of ((values 3) 't 2))
                "application: the value 3 is a number; it cannot be applied to the arguments t 2"))

(test-case "a symbol suggests a literal function"
  (check-equal? (message-of (x 't))
                (string-append "x: the symbol x is a number here, not a function; "
                               "(literal-function 'x) makes a function of it"))
  (check-equal? (message-of ('y 't))
                (string-append "application: the symbol y is a number here, not a function; "
                               "(literal-function 'y) makes a function of it")))

(test-case "an operation between its operands is told to come first"
  (define m 2)
  (check-equal? (message-of (2 g:* 'x)) "application: operations come first: (* 2 'x)")
  (check-equal? (message-of ('x g:+ 2)) "application: operations come first: (+ 'x 2)")
  (check-equal? (message-of (m g:* 3)) "m: operations come first: (* m 3)")
  (check-equal? (message-of (x g:- 3 g:* 4)) "x: operations come first, as in (- x 3)")
  (check-equal? (message-of ((g:+ 'a 'b) quotient-of 2))
                "application: operations come first: (/ (+ a b) 2)")
  (check-equal? (message-of (m g:= 3)) "m: operations come first: (= m 3)")
  (check-equal? (message-of (m g:*)) "m: operations come first, as in (* m ...)")
  (check-equal? (message-of (m 3 g:*))
                "m: the value 2 is a number; it cannot be applied to the arguments 3 *"))

(test-case "an expression says that it is number-like"
  (check-equal? (message-of ((g:+ 'a 'b) 't))
                (string-append "application: the value (+ a b) is a number-like expression; it "
                               "cannot be applied to the argument t")))

(test-case "a list is told from a tuple"
  (check-equal? (message-of (pair 't))
                "pair: a list is not a tuple; use (up 1 2)")
  (check-equal? (message-of ((list 'a 2) 't))
                "application: a list is not a tuple; use (up a 2)"))

(test-case "other values are described"
  (check-equal? (message-of ("s" 't))
                "application: the value \"s\" is a string; it cannot be applied to the argument t")
  (check-equal? (message-of ((void)))
                (string-append "application: the value #<void> is no value (void); it cannot "
                               "be applied to no arguments")))

(test-case "keyword arguments do not hide the message"
  (check-equal? (message-of (three 1 #:key 2))
                "three: the value 3 is a number; it cannot be applied to the argument 1"))

(test-case "arguments are evaluated before the complaint, from left to right"
  (define seen '())
  (define (note i) (set! seen (cons i seen)) i)
  (message-of (three (note 1) (note 2)))
  (check-equal? seen '(2 1)))

(test-case "a Racket vector is applied as the up tuple it stands for"
  (define functions (vector add1 sub1))
  (check-equal? (functions 3) (up 4 2))
  (check-equal? ((vector sub1 add1) 3) (up 2 4)))

;; ---------------------------------------------------------------------------
;; Functions

(test-case "tuples, closures, primitives and keyword functions are applied"
  (define (f a #:k [k 1] . rest) (list a k rest))
  (define g f)
  (check-equal? ((up add1 sub1) 3) (up 4 2))
  (check-equal? (let ([h (lambda (x) (* 2 x))]) (h 4)) 8)
  (check-equal? (f 1 2 #:k 3) '(1 3 (2)))
  (check-equal? (g 1 #:k 3) '(1 3 ()))
  (check-equal? (((lambda (x) (lambda (y #:z z) (list x y z))) 1) 2 #:z 3) '(1 2 3)))

(test-case "arguments are evaluated once, from left to right, also when one assigns another"
  (define n 0)
  (define (next!) (set! n (+ n 1)) n)
  (define collect (lambda args args))
  (check-equal? (collect n (next!) n (next!)) '(0 1 1 2)))

(test-case "multiple values in an argument are an error as ever"
  (check-exn exn:fail:contract:arity? (lambda () (let ([f add1]) (f (values 1 2))))))

(test-case "calls stay in tail position"
  (define (loop f n) (if (eq? n 0) 'done (f f (- n 1))))
  (define ((curried f) n) (if (eq? n 0) 'done ((curried f) (- n 1))))
  (check-equal? (loop loop 1000000) 'done)
  (check-equal? ((curried 0) 1000000) 'done))

(test-case "arguments that are procedures get no name from us"
  (define (name-of f [other #f]) (object-name f))
  (check-regexp-match #rx":[0-9]+:[0-9]+$"
                      (symbol->string (name-of (lambda (x) x) (add1 1)))))

(test-case "imported functions and lambda expressions are applied as by Racket"
  (check-false (mentions? 'if (expanded '(cons 1 (list 2 3)))))
  (check-false (mentions? 'if (expanded '((lambda (x) x) 3))))
  (check-true (mentions? 'if (expanded '(lambda (f) (f 3))))))

(test-case "improper applications are refused as by Racket"
  (define (syntax-message form)
    (message-of (expanded form) exn:fail:syntax?))
  (check-regexp-match #rx"missing procedure expression" (syntax-message '()))
  (check-regexp-match #rx"#%app: bad syntax" (syntax-message '(f . 3))))
