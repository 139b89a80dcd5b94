#lang racket/base
;; Second definitions in a `#lang mechanics` module.

(require "../../support/checks.rkt" "../../support/run-text.rkt")

(test-case "functions defined before see the new definition"
  (check-equal? (prints "(define (f x) (* 2 (g x)))"
                        "(define (g x) (+ x 1))"
                        "(f 1)"
                        "(define (g x) (* x 100))"
                        "(f 1)"
                        "(define g square)"
                        "(f 5)")
                (lines "4" "200" "50")))

(test-case "a new definition may use the value before it"
  (check-equal? (prints "(define x 1)" "(define x (+ x 1))" "x" "(define x (list x x))" "x")
                (lines "2" "'(2 2)")))

(test-case "a new definition may take other arguments, and bears the name"
  (check-equal? (prints "(define (f x) x)"
                        "(define (f x y) (list x y))"
                        "(f 1 2)"
                        "f"
                        "(define ((f m) (up t q v)) (* m v))"
                        "((f 'm) (up 't 'x 'v))"
                        "(f 'm)"
                        "(define f (let ([n 0]) (lambda () n)))"
                        "f")
                (lines "'(1 2)" "f" "(* m v)" "f" "f"))
  (check-equal? (failure "(define (f x) x)" "(define (f x y) x)" "(f 1)")
                (list "" (string-append
                          "f: arity mismatch;\n the expected number of arguments does not match"
                          " the given number\n  expected: 2\n  given: 1"))))

(test-case "functions that call each other may be replaced one at a time"
  (check-equal? (prints "(define (even-steps n) (if (= n 0) 'even (odd-steps (- n 1))))"
                        "(define (odd-steps n) (if (= n 0) 'odd (even-steps (- n 1))))"
                        "(even-steps 5)"
                        "(define (odd-steps n) (list 'stopped-at n))"
                        "(even-steps 5)")
                (lines "odd" "'(stopped-at 4)")))

(test-case "keyword arguments and patterns may be defined again"
  (check-equal? (prints "(define (f #:a a) a)"
                        "(f #:a 1)"
                        "(define (f #:b [b 2] (up c d)) (list b c d))"
                        "(f #:b 1 (up 3 4))"
                        "(f (up 3 4))"
                        "(define ((f #:c c) x) (list c x))"
                        "((f #:c 1) 2)")
                (lines "1" "'(1 3 4)" "'(2 3 4)" "'(1 2)")))

(test-case "several values may be defined again, some of them new"
  (check-equal? (prints "(define-values (p q) (values 1 2))"
                        "(define-values (q r) (values 3 4))"
                        "(list p q r)"
                        "(define-values (r q) (values q r))"
                        "(match-define (list p s) (list (list p q r) 5))"
                        "(list p q r s)")
                (lines "'(1 3 4)" "'((1 4 3) 4 3 5)")))

(test-case "definitions inside begin, and those that macros make, are definitions"
  (check-equal? (prints "(define-syntax-rule (def x e) (define x e))"
                        "(def a 1)"
                        "a"
                        "(begin (def a 2) a (begin (define a 3)))"
                        "a"
                        "(begin)")
                (lines "1" "2" "3")))

(test-case "names that a macro makes are its own"
  (check-equal? (prints "(define-syntax-rule (show e) (begin (define t e) t))"
                        "(define t 5)"
                        "(show 1)"
                        "(show 2)"
                        "t")
                (lines "1" "2" "5")))

(test-case "what is assigned, bound locally or quoted is not mixed up with it"
  (check-equal? (prints "(define x 1)"
                        "(define (next!) (set! x (+ x 1)) x)"
                        "(next!)"
                        "(define x 10)"
                        "(next!)"
                        "((lambda (x) x) 'local)"
                        "(let () (define x 'inner) (define y x) y)"
                        "'x")
                (lines "2" "11" "local" "inner" "x")))

(test-case "other modules and submodules see the last definition"
  (check-equal? (run-submodule 'inner language
                               "(provide (all-defined-out))"
                               "(define x (square 1))"
                               "(module* inner racket/base"
                               "  (require (submod \"..\"))"
                               "  (writeln (list x (f) (square 1) (g #:b 3))))"
                               "(define (f) x)"
                               "(define x 2)"
                               "(define (square x) 'mine)"
                               "(define (g #:a a) a)"
                               "(define (g #:b b) b)")
                (lines "(2 2 mine 3)"))
  (check-equal? (run-submodule 'test language
                               "(define x 1)"
                               "(module+ test x)"
                               "(define x 2)"
                               "(module+ test (define y x) y (define y 3) y)")
                (lines "2" "2" "3")))

(test-case "macros see the last definition, code for-syntax is apart"
  (check-equal? (prints "(require (for-syntax racket/base))"
                        "(define-syntax (value stx) #'(list x))"
                        "(define-for-syntax x 'other)"
                        "(define x 1)"
                        "(value)"
                        "(define x 2)"
                        "(value)"
                        "(define-syntax (other stx) #`'#,x)"
                        "(other)")
                (lines "'(1)" "'(2)" "other")))

(test-case "a structure's functions may be replaced, a structure or a macro may not"
  (check-equal? (prints "(struct point (x y))"
                        "(define (point-x p) 'mine)"
                        "(point-x (point 1 2))"
                        "(point-y (point 1 2))")
                (lines "mine" "2"))
  (define (message place name)
    (string-append
     "example:" place ": " name ": already defined, on line 2; in a module only variables"
     " and functions may be defined again, not macros or structure types\n  in: " name))
  (check-equal? (refusal "(struct point (x y))" "(struct point (x y z))")
                (message "3:8" "point"))
  (check-equal? (refusal "(struct point (x y))" "(define (point x y) x)")
                (message "3:9" "point"))
  (check-equal? (refusal "(define-syntax-rule (twice x) (+ x x))" "(define (twice x) x)")
                (message "3:9" "twice"))
  (check-equal? (refusal "(define (twice x) x)" "(define-syntax-rule (twice x) (+ x x))")
                (message "3:21" "twice"))
  (check-equal? (refusal "(define-syntax-rule (twice x) x)"
                         "(define-syntax-rule (twice x) (+ x x))")
                (message "3:21" "twice")))

(test-case "a definition that is wrong is refused as ever, the second time too"
  (check-equal? (refusal "(define f 1)" "(define (f x))")
                (string-append "example:3:0: define: no expressions for procedure body; "
                               "it is written (define (f x) (* 2 x))\n  in: (define (f x))"))
  (check-regexp-match #rx"^example:3:0: define: f has no value"
                      (refusal "(define f 1)" "(define f)"))
  (check-regexp-match #rx"^example:3:11: define: \\(x y z\\) is no argument"
                      (refusal "(define f 1)" "(define (f (x y z)) x)")))
