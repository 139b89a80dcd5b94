#lang racket/base
;; A sum of functions begun at 0 printed its 0, and the negative of a function
;; its -1; `Any` in a signature let lists and functions into expressions.

(require mechanics/generic/arithmetic mechanics/generic/sums-and-products
         mechanics/calculus/derivative mechanics/calculus/literal-function
         mechanics/value/signature mechanics/value/structure
         "../support/checks.rkt")

(define f (literal-function 'f))

(test-case "0 + f and 1 f are f itself, for functions, operators and tuples"
  (for ([x (list f D (up f f))])
    (check-eq? (g:+ 0 x) x)
    (check-eq? (g:+ x 0) x)
    (check-eq? (g:* 1 x) x)
    (check-eq? (g:* x 1) x)
    (check-eq? (g:+ x) x)
    (check-eq? (g:* x) x))
  (check-equal? (format "~a" (g:for/sum ([_ 2]) f)) "(+ f f)"))

(test-case "the negative of a function prints as that"
  (check-equal? (format "~a" (g:- f)) "(- f)")
  (check-equal? ((g:- f) 't) (g:* -1 (f 't)))
  (check-equal? ((D (g:- f)) 't) (g:* -1 ((D f) 't))))

(test-case "Any is any tuple of scalars"
  (define S (literal-function 'S (-> Any Real)))
  (check-equal? (format "~a" (S (up 'x (down 1 2)))) "(S (up x (down 1 2)))")
  (check-exn #rx"^S: was declared [(]-> Any Real[)]; slot 0 got f, a literal function"
             (lambda () (S f)))
  (check-exn #rx"^S: .*slot 0 got [(]up 1 [(]2 3[)][)], an up tuple of 2"
             (lambda () (S (up 1 '(2 3))))))
