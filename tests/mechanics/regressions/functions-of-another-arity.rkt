#lang racket/base
;; A function of two numbers, given where one of one number is integrated, minimized or
;; searched for a root, was shown as #<procedure>.

(require mechanics "../support/checks.rkt")

(define (product x y) (* x y))

(define-syntax-rule (check-given who given expression)
  (check-exn (lambda (e)
               (and (exn:fail:contract? e)
                    (equal? (exn-message e)
                            (string-append who ": "
                                           "expected a function of one variable\n"
                                           "  given: " given))))
             (lambda () expression)))

(test-case "how many arguments it takes is said"
  (define named "the procedure `product`, which takes 2 arguments")
  (check-given "definite-integral" named (definite-integral product 0 1))
  (check-given "minimize" named (minimize product 0 1))
  (check-given "multidimensional-minimize" named (multidimensional-minimize product (up 0 1)))
  (check-given "find-root" named (find-root product 0 1))
  (check-given "D-numeric" named (D-numeric product))
  (check-given "minimize" "a function without a name, which takes 0 arguments"
               (minimize (lambda () 1) 0 1)))

(test-case "what is no function is shown as any value"
  (check-given "definite-integral" "the number 0" (definite-integral 0 1 sin))
  (check-given "find-root" "the symbol x" (find-root 'x 0 1)))
