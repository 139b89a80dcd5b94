#lang racket/base
;; The solution of a system, an operation of the compiler's alone, broke the test modulo primes off
;; with an error of fixnums: the falling coin could not be exported.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/zero/vanishing
         "../support/checks.rkt")

(test-case "such an operation is taken for an unknown function"
  (define (solution . es) (make-node op:solution es))
  (check-false (vanishes? (solution 'a 'b)))
  (check-false (vanishes? (e:- (solution 'a 'b) (solution 'b 'a))))
  (check-true (vanishes? (e:- (e:* 2 (solution 'a 'b)) (e:+ (solution 'a 'b) (solution 'a 'b))))))
