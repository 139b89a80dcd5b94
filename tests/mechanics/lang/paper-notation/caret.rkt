#lang racket/base
;; `^`, for powers as they are written elsewhere.

(require "../../support/checks.rkt" "../../support/messages.rkt"
         "../../support/run-text.rkt")

(define said "^: powers are (expt x 2)\n")

(define (prompt-says form)
  (define space (make-base-empty-namespace))
  (parameterize ([current-namespace space])
    (namespace-require 'mechanics)
    (message-of (eval form) exn:fail:syntax?)))

(test-case "a power is said to be written with expt, at the prompt and in files"
  (for ([form '((^ 'x 2) (* 1/2 'm (^ 'v 2)) ('x ^ 2) ^)])
    (check-regexp-match (regexp-quote said) (prompt-says form)))
  (check-regexp-match (regexp-quote said)
                      (message-of (run-module "#lang mechanics" "(define (f x) (^ x 2))")
                                  exn:fail:syntax?)))

(test-case "who defines ^ has it"
  (check-equal? (run-module "#lang mechanics" "(define (^ a b) (expt a b))" "(^ 3 2)") "9\n"))
