#lang racket/base
;; Sums and products over sequences.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/sums-and-products
         mechanics/generic/up-down
         mechanics/calculus/derivative
         "../support/checks.rkt")

(test-case "sums and products of numbers are Racket's"
  (check-equal? (g:for/sum ([i 5]) i) 10)
  (check-equal? (g:for/product ([i (in-range 1 6)]) i) 120)
  (check-equal? (g:for/sum ([i 3] [j '(10 20 30)] #:when (odd? i)) (+ i j)) 21)
  (check-equal? (g:for*/sum ([i 3] [j 3]) (* i j)) 9)
  (check-equal? (g:for*/product ([i '(1 2)] [j '(3 4)]) (* i j)) 576))

(test-case "an empty sum is 0 and an empty product 1"
  (check-equal? (g:for/sum ([i '()]) 'a) 0)
  (check-equal? (g:for/product ([i '()]) 'a) 1))

(test-case "sums of symbols, tuples and functions"
  (check-equal? (g:for/sum ([s '(a b c)]) s) (g:+ 'a 'b 'c))
  (check-equal? (g:for/sum ([i 3]) (up i 1)) (up 3 3))
  (check-equal? ((g:for/sum ([n 3]) (lambda (x) (g:expt x n))) 2) 7))

(test-case "a tuple is a sequence"
  (check-equal? (g:for/sum ([x (up 1 2 'a)]) x) (g:+ 3 'a))
  (check-equal? (for/list ([x (down 1 (up 2 3))]) x) (list 1 (up 2 3))))

(test-case "a loop has a derivative"
  (check-equal? ((D (lambda (x) (g:for/sum ([n (in-range 1 5)]) (g:expt x n)))) 2) 49)
  (check-equal? ((D (lambda (x) (g:for/product ([n 4]) (g:+ x n)))) 0) 6))

(test-case "break clauses and bodies with definitions work"
  (check-equal? (g:for/sum ([i 10] #:break (= i 3)) (define j (* 2 i)) j) 6))

(test-case "a summand that cannot be added is named"
  (check-exn #rx"^[+]: cannot add a number and a list" (lambda () (g:for/sum ([i 3]) '(1)))))

(test-case "#:break and #:final in the body, and definitions"
  (check-equal? (g:for/sum ([i 5]) #:break (= i 3) i) 3)
  (check-equal? (g:for/sum ([i 5]) (define j (* i 2)) #:final (= i 2) j) 6)
  (check-equal? (g:for*/product ([i '(1 2)] [j '(a b)]) #:break (eq? j 'b) (g:* i j)) 'a))
