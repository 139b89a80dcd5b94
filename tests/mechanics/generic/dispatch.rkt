#lang racket/base
;; Messages of generic operations on arguments they do not take: the exact text.

(require mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/up-down
         mechanics/value/matrix/matrix
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/lang/application
         "../support/checks.rkt" "../support/messages.rkt")

;; ---------------------------------------------------------------------------
;; Kinds that do not combine

(says
 [(g:+ 'a (up 1 2))
  "+: cannot add a number-like expression and an up tuple of 2\n"
  "  argument 1: the symbol a\n"
  "  argument 2: (up 1 2), an up tuple of 2"]
 [(g:- (down 1 2) 3)
  "-: cannot subtract a number from a down tuple of 2\n"
  "  argument 1: (down 1 2), a down tuple of 2\n"
  "  argument 2: the number 3"]
 [(g:+ (up 1 2) (up 1 2 3))
  "+: cannot add an up tuple of 2 and an up tuple of 3\n"
  "  argument 1: (up 1 2), an up tuple of 2\n"
  "  argument 2: (up 1 2 3), an up tuple of 3\n"
  "  their lengths differ"]
 [(g:+ (up 1 2) (down 'x 'y))
  "+: cannot add an up tuple of 2 and a down tuple of 2\n"
  "  argument 1: (up 1 2), an up tuple of 2\n"
  "  argument 2: (down x y), a down tuple of 2\n"
  "  their orientations differ"]
 [(g:+ (up 1 (up 2 3)) (up 1 (up 2 3 4)))
  "+: cannot add an up tuple of 2 and an up tuple of 3\n"
  "  argument 1: (up 2 3), an up tuple of 2\n"
  "  argument 2: (up 2 3 4), an up tuple of 3\n"
  "  their lengths differ"]
 [(g:/ 'a (up 1 2))
  "/: cannot divide a number-like expression by an up tuple of 2\n"
  "  argument 1: the symbol a\n"
  "  argument 2: (up 1 2), an up tuple of 2"]
 [(g:expt (up 1 2) 'n)
  "expt: cannot raise an up tuple of 2 to the power of a number-like expression\n"
  "  argument 1: (up 1 2), an up tuple of 2\n"
  "  argument 2: the symbol n"]
 [(g:* (matrix-by-rows '(1 2)) (up 1 2 3))
  "*: cannot multiply a 1 by 2 matrix by an up tuple of 3\n"
  "  argument 1: (matrix-by-rows (list 1 2)), a 1 by 2 matrix\n"
  "  argument 2: (up 1 2 3), an up tuple of 3"]
 [(g:/ 2 D)
  "/: cannot divide a number by an operator\n"
  "  argument 1: the number 2\n"
  "  argument 2: D, an operator"]
 [(g:atan (up 1 2) 1)
  "atan: cannot be taken of an up tuple of 2 and a number\n"
  "  argument 1: (up 1 2), an up tuple of 2\n"
  "  argument 2: the number 1"])

;; ---------------------------------------------------------------------------
;; Things that are no part of the arithmetic

(says
 [(g:+ '(1 2) 3)
  "+: cannot add a list and a number\n"
  "  argument 1: (1 2), a list\n"
  "  argument 2: the number 3\n"
  "  a list is not a tuple; use (up x y ...)"]
 [(g:* 'm '(x y))
  "*: cannot multiply a number-like expression by a list\n"
  "  argument 1: the symbol m\n"
  "  argument 2: (x y), a list\n"
  "  a list is not a tuple; use (up x y ...)"]
 [(g:square '(1 2))
  "square: cannot be taken of a list\n"
  "  argument 1: (1 2), a list\n"
  "  a list is not a tuple; use (up x y ...)"]
 [(g:+ 1 "two")
  "+: cannot add a number and a string\n"
  "  argument 1: the number 1\n"
  "  argument 2: \"two\", a string"]
 [(g:sin #t)
  "sin: cannot be taken of a boolean\n"
  "  argument 1: #t, a boolean"]
 [(g:sqrt (up 1 2))
  "sqrt: cannot be taken of an up tuple of 2\n"
  "  argument 1: (up 1 2), an up tuple of 2"]
 [(g:log D)
  "log: cannot be taken of an operator\n"
  "  argument 1: D, an operator"]
 [(g:+ (void) 1)
  "+: cannot add no value (void) and a number\n"
  "  argument 1: #<void>, no value (void)\n"
  "  argument 2: the number 1"])

;; ---------------------------------------------------------------------------
;; Slips of the parenthesis, as the language's own application sees them

(define V (literal-function 'V))

(says
 [(g:abs g:- 10.3) "abs: expected 1 argument, given 2: the procedure `-`, 10.3"]
 [(g:abs) "abs: expected 1 argument, given 0"]
 [(g:sin V 't) "sin: expected 1 argument, given 2: V, t"]
 [(g:sqrt (lambda (x) x) (up 1 2))
  "sqrt: expected 1 argument, given 2: a function without a name, (up 1 2)"])

(test-case "a wrong number of arguments is an arity error"
  (check-exn exn:fail:contract:arity? (lambda () (g:abs g:- 10.3)))
  (check-exn exn:fail:contract:arity? (lambda () (apply g:abs '(1 2))))
  (check-exn exn:fail:contract:arity? (lambda () (g:expt 2)))
  (check-exn #rx"^expt: " (lambda () (g:expt 2))))

;; ---------------------------------------------------------------------------
;; Division by zero

(says
 [(g:/ 'a 0) "/: division by zero\n  in: (/ a 0)"]
 [(g:/ 1 0) "/: division by zero"]
 [(g:/ (up 1 'a) 0) "/: division by zero"])

(test-case "division by zero is the exception that Racket has for it"
  (check-exn exn:fail:contract:divide-by-zero? (lambda () (g:/ 'a 0)))
  (check-exn exn:fail:contract:divide-by-zero? (lambda () (g:/ (up 'a 1) 0))))

;; ---------------------------------------------------------------------------
;; Order

(says
 [(g:< 'a 'b)
  "<: an expression that is not a number has no order; give its symbols values first\n"
  "  as an assumption, the relation is quoted: (assume '(< a b))\n"
  "  value: the symbol a"]
 [(g:>= 1 (g:sin 'x))
  ">=: an expression that is not a number has no order; give its symbols values first\n"
  "  as an assumption, the relation is quoted: (assume '(>= 1 (sin x)))\n"
  "  value: (sin x), a number-like expression"]
 [(g:< (up 1 2) 3)
  "<: expected real numbers\n  value: (up 1 2), an up tuple of 2"]
 [(g:> 1 +2i)
  ">: expected real numbers\n  value: the number 0+2i"]
 [(g:positive? 'm)
  "positive?: an expression that is not a number has no order; give its symbols values first\n"
  "  value: the symbol m"]
 [(g:max 'a 1)
  "max: an expression that is not a number has no order; give its symbols values first\n"
  "  value: the symbol a"])
