#lang racket/base
;; Zero or not, for algorithms that divide.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/calculus/literal-function
         mechanics/algebra/zero/vanishing
         "../../support/checks.rkt")

(define f (literal-function 'f))

(define zeros
  (list 0 0.0
        (g:- (g:+ (g:square (g:sin 'x)) (g:square (g:cos 'x))) 1)
        (g:- (g:square (g:+ 'a 'b)) (g:+ (g:square 'a) (g:* 2 'a 'b) (g:square 'b)))
        (g:- (g:sin (g:+ 'a 'b)) (g:+ (g:* (g:sin 'a) (g:cos 'b)) (g:* (g:cos 'a) (g:sin 'b))))
        (g:- (g:sqrt (g:* 'x 'x 'y)) (g:* 'x (g:sqrt 'y)))
        (g:- (g:exp (g:+ 'a 'b)) (g:* (g:exp 'a) (g:exp 'b)))
        (g:- (f (g:+ 'x 'x)) (f (g:* 2 'x)))
        (g:- (g:* 0.5 'x) (g:/ 'x 2))))

(define others
  (list 1 1e-300 'x (g:sin 'x) (f 'x)
        (g:- (g:+ (g:square (g:sin 'x)) (g:square (g:cos 'x))) 2)
        (g:- (g:sqrt (g:+ 'x 1)) (g:+ 1 (g:sqrt 'x)))
        (g:- (f 'x) (f 'y))
        (g:log 'x)))

(test-case "zeros in disguise are seen, and nothing else is taken for one"
  (for ([e (in-list zeros)]) (check-true (vanishes? e) (format "~a" e)))
  (for ([e (in-list others)]) (check-false (vanishes? e) (format "~a" e))))

(test-case "a large graph is judged by its nodes"
  (define big (for/fold ([e 'x]) ([k 60]) (g:+ (g:* e e) k)))
  (check-false (vanishes? big)))
