#lang racket/base
;; Numbers for leaves: one for each symbol, one for equal arguments of a function.

(require mechanics/algebra/expression/read
         mechanics/algebra/zero/assignment
         mechanics/algebra/ball/ball
         "../../support/checks.rkt")

(define (leaf d) (datum->expression d))

;; Each choice is another number.
(define (make-choice)
  (define n 0)
  (lambda () (set! n (+ n 1)) n))

(define (make-assign)
  (define a (make-assignment))
  (define choice (make-choice))
  (lambda (d . arguments) (assigned a (leaf d) arguments choice)))

(test-case "a symbol has one number, a function one for each of its arguments"
  (define assign (make-assign))
  (check-equal? (list (assign 'x) (assign 'y) (assign 'x)) '(1 2 1))
  (check-equal? (list (assign '(V x) 5) (assign '(V y) 6) (assign '(V y) 5)) '(3 4 3))
  (check-equal? (list (assign '((D V) x) 5) (assign '(W x) 5)) '(5 6))
  (check-equal? (list (assign '(F x) '(up 1 2)) (assign '(F x) '(up 2 1)) (assign '(F x) '(up 1 2)))
                '(7 8 7)))

(test-case "arguments whose balls overlap count as equal, with one value among them"
  (define assign (make-assign))
  (define two (flonum->ball 2.0 80))
  (check-equal? (list (assign '(V x) 2) (assign '(V x) two) (assign '(V x) (flonum->ball 2.1 80)))
                '(1 1 2)))

(test-case "what may equal two that differ has no value"
  (define assign (make-assign))
  (assign '(V x) 2)
  (assign '(V x) (+ 2 (expt 10 -17)))
  (check-eq? (with-handlers ([symbol? values]) (assign '(V x) (flonum->ball 2.0 80))) unknown))

(test-case "sources are always the same, and positive ones are positive"
  (define (first-of source k n) (let ([next (source k)]) (for/list ([_ (in-range n)]) (next))))
  (for* ([source (in-list (list integers-from fractions-from))] [k (in-range -8 12)])
    (check-equal? (first-of source k 9) (first-of source k 9))
    (unless (negative? k) (check-true (andmap positive? (first-of source k 50)))))
  (check-true (ormap negative? (first-of integers-from -1 50)))
  (check-true (andmap (lambda (x) (< 0 x 1)) (first-of fractions-from 0 50)))
  (check-true (for/or ([k (in-range 16)]) (eqv? 1/1000 (car (first-of fractions-from k 1))))))
