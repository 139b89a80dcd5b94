#lang racket/base
;; Structs that are values: what each clause of the form gives them.

(require mechanics/generic/arithmetic
         mechanics/generic/kind
         mechanics/generic/value-struct
         "../support/checks.rkt")

(define (printed x) (list (format "~s" x) (format "~a" x) (format "~v" x)))

(define kind:money
  (make-kind #:rank rank:number
             #:describe (lambda (m) "money")
             #:datum (lambda (m) (list 'money (money-amount m)))
             #:binary (lambda (op a b) (list (generic-op-name op) a b))))

(value-struct money (amount)
  #:kind kind:money
  #:equal-by money-amount)

(value-struct price money (of)
  #:constructor-name make-price
  #:omit-define-syntaxes)

(define kind:coin (make-kind #:rank rank:number #:describe (lambda (c) "a coin") #:datum values))

(value-struct coin (amount)
  #:kind kind:coin
  #:text coin->text)

(define (coin->text c) (format "~a ct" (coin-amount c)))

(value-struct pair-of (a b [count #:mutable])
  #:datum (lambda (p) (list 'pair-of (pair-of-a p) (pair-of-b p)))
  #:equality (lambda (p q recur) (recur (pair-of-a p) (pair-of-a q)))
             (lambda (p recur) (recur (pair-of-a p)))
  #:property prop:procedure (lambda (p x) (list x (pair-of-b p))))

(test-case "a value prints the same in all modes, as its datum, its kind's, or its text"
  (check-equal? (printed (money 3)) '("(money 3)" "(money 3)" "(money 3)"))
  (check-equal? (printed (pair-of 1 'x 0)) '("(pair-of 1 x)" "(pair-of 1 x)" "(pair-of 1 x)"))
  (check-equal? (printed (coin 3)) '("3 ct" "3 ct" "3 ct"))
  (check-equal? (format "~v" (list (money 3))) "(list (money 3))"))

(test-case "what a value is made of inherits how it prints"
  (define p (make-price 3 'tea))
  (check-true (money? p))
  (check-equal? (price-of p) 'tea)
  (check-equal? (format "~v" p) "(money 3)"))

(test-case "values of a kind join the arithmetic"
  (define m (money 3))
  (check-eq? (kind-of m) kind:money)
  (check-equal? (g:+ m 'x) (list '+ m 'x)))

(test-case "values are equal by their part, or as they say, with hash codes to match"
  (check-equal? (money 3) (money 3))
  (check-not-equal? (money 3) (money 4))
  (check-equal? (equal-hash-code (money "a")) (equal-hash-code (money (string #\a))))
  (check-equal? (pair-of 1 'x 0) (pair-of 1 'y 0))
  (check-not-equal? (pair-of 1 'x 0) (pair-of 2 'x 0))
  (check-equal? (hash-ref (hash (pair-of 1 'x 0) 'found) (pair-of 1 'y 0) #f) 'found)
  (check-not-equal? (coin 3) (coin 3)))

(test-case "options of struct follow the clauses"
  (define p (pair-of 1 'x 0))
  (check-equal? (p 5) '(5 x))
  (set-pair-of-count! p 7)
  (check-equal? (pair-of-count p) 7))

(test-case "a value is authentic"
  (check-exn #rx"^impersonate-struct: "
             (lambda () (impersonate-struct (pair-of 1 2 3) pair-of-a (lambda (p a) a)))))
