#lang racket/base
;; In arithmetic with a function, the functions inside a matrix were not applied.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/structure
         mechanics/value/matrix/matrix
         "../support/checks.rkt")

(test-case "a matrix of functions times a function is evaluated entry by entry"
  (define M (matrix-by-rows (list g:sin 1) (list 0 g:cos)))
  (define f (lambda (t) (up t 2)))
  (check-equal? ((g:* M f) 'a)
                (g:* (matrix-by-rows (list (g:sin 'a) 1) (list 0 (g:cos 'a))) (up 'a 2))))
