#lang racket/base
;; Names used before their definition in a `#lang mechanics` module.

(require "../../support/checks.rkt" "../../support/run-text.rkt")

(define (early name line)
  (format "~a: used before its definition, which is on line ~a; a module is run from top to bottom"
          name line))

(test-case "a name that is used before its definition is told from where it is defined"
  (check-equal? (failure "'before" "(list x)" "(define x 1)")
                (list (lines "before") (early 'x 4)))
  (check-equal? (failure "(define y (+ x 1))" "(define x 1)")
                (list "" (early 'x 3)))
  (check-equal? (failure "(define x (+ x 1))") (list "" (early 'x 2))))

(test-case "so is one that a function uses which is called too early"
  (check-equal? (failure "(define (f) (h))" "(define (h) (g 1))" "(f)" "(define (g x) x)")
                (list "" (early 'g 5)))
  (check-equal? (failure "(define (f) (g 1))" "(define y (f))" "(define (g x) x)")
                (list "" (early 'g 4))))

(test-case "a program may notice that a name has no value yet"
  (check-equal? (prints "(define (f) (g))"
                        "(with-handlers ([exn:fail:contract:variable?"
                        "                 exn:fail:contract:variable-id])"
                        "  (f))"
                        "(define (g) 1)"
                        "(f)")
                (lines "g" "1")))
