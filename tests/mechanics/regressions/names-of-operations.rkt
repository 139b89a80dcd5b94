#lang racket/base
;; Generic operations called themselves by their internal names.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/compare
         mechanics/lang/application
         "../support/checks.rkt")

(test-case "an operation goes by the name the reader types"
  (for ([f (list g:+ g:- g:* g:/ g:square g:cube g:negate g:invert
                 g:sqrt g:exp g:log g:sin g:cos g:tan g:asin g:acos g:atan
                 g:sinh g:cosh g:tanh g:asinh g:acosh g:atanh g:abs g:sgn g:expt
                 g:sec g:csc g:cot g:sech g:csch g:coth
                 g:= g:< g:> g:<= g:>= g:zero? g:one? g:positive? g:negative?
                 g:max g:min g:add1 g:sub1)]
        [name '(+ - * / square cube negate invert
                sqrt exp log sin cos tan asin acos atan
                sinh cosh tanh asinh acosh atanh abs sgn expt sec csc cot sech csch coth
                = < > <= >= zero? one? positive? negative?
                max min add1 sub1)])
    (check-equal? (object-name f) name)))

(test-case "and so it stands in a message"
  (check-exn #rx"^abs: expected 1 argument, given 2: the procedure `-`, 10.3$"
             (lambda () (g:abs g:- 10.3))))
