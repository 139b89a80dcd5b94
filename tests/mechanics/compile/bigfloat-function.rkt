#lang racket/base
;; Functions on numbers of higher precision: as programs, or as they are.

(require (prefix-in m: mechanics)
         mechanics/compile/bigfloat-function
         mechanics/numeric/bigfloat/bigfloat-arithmetic
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

;; -> the exact values of f at x in 64 bits, and whether f could be traced
(define (value-and-traced f x)
  (with-bits 64
    (define-values (run shape traced?) (bigfloat-function 'test f x))
    (values (exact-value (vector-ref (run (vector (real->bigfloat x))) 0)) traced?)))

(skip-unless bigfloats? no-bigfloats
  (test-case "arithmetic becomes a program"
    (define-values (value traced?) (value-and-traced (lambda (x) (m:+ 1/4 (m:* 3 x x))) 1/2))
    (check-true traced?)
    (check-equal? value 1))

  (test-case "what is no operation on such numbers is left to the function"
    (define-values (value traced?) (value-and-traced (m:principal-value m:pi) 1/2))
    (check-false traced?)
    (check-equal? value 1/2))

  (test-case "what is no number is told by who asks"
    (for ([x '("no" m)] [words '("\"no\", a string" "the symbol m")])
      (check-exn (regexp (string-append "^test: expected real numbers; given " words "$"))
                 (lambda () (bigfloat-function 'test values x)))))

  (test-case "a function that tells placeholders from numbers is called"
    (define (traced-at-all? f)
      (define-values (value traced?) (value-and-traced f 3))
      (check-equal? value 3)
      traced?)
    (check-false (traced-at-all? (lambda (x) (if (symbol? x) (m:+ x 1) x))))
    (check-false (traced-at-all? (lambda (x) (m:up x (if (symbol? x) (m:+ x 1) x)))))
    ;; where the program has no value, too
    (check-false (traced-at-all? (lambda (x) (if (symbol? x) (m:sqrt (m:- -1 (m:* x x))) x))))))
