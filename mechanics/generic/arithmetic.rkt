#lang racket/base
;; The four operations, generic.
;;
;; Each is first asked of two flonums or two numbers, which costs a test; all
;; else goes through `dispatch-binary`.  Next to every operation stands the
;; record of it that kinds see, made of its entry in the table of operations; an
;; operation made of others, as a square of a product, has no entry there and no symbol
;; in expressions.

(require racket/flonum
         "dispatch.rkt" "function.rkt" "kind.rkt" "naming.rkt" "operation-rule/operation-record.rkt"
         "up-down.rkt"
         "../algebra/expression/expression.rkt")

;; Values taken apart here have just been recognized, and the kind of a carrier is a
;; kind: to test that again would take a fifth of a derivative's time.
(#%declare #:unsafe)

(provide g:+ g:- g:* g:/ g:square g:cube g:negate g:invert
         generic:+ generic:- generic:* generic:/ generic:square arithmetic-operations)

;; (define-binary (name a b) generic flonum numeric symbolic structural [test value] ...)
;; of two flonums, two numbers, values that the tests find, two expressions, else structures
(define-syntax-rule (define-binary (name a b) generic flonum numeric symbolic structural
                      [test value] ...)
  (begin
    (define (name a b)
      (cond [(and (flonum? a) (flonum? b)) (flonum a b)]
            [else (dispatch-carriers generic a b (other a b))]))
    (define (other a b)
      (cond [(and (number? a) (number? b)) (numeric a b)]
            [test value] ...
            [else (dispatch-binary generic symbolic structural a b)]))))

;; Of any number of arguments: two, those that the clauses are for, more from the left.
(define-syntax-rule (define-variadic id name two clause ...)
  (define-named id name
    (case-lambda
      [(a b) (two a b)]
      clause ...
      [(a b . more) (for/fold ([value (two a b)]) ([x (in-list more)]) (two value x))])))

;; ---------------------------------------------------------------------------
;; Sums

(define-binary (add a b) generic:+ fl+ + e:+ add-structures
  [(and (structure? a) (structure? b)) (add-structures a b)]
  [(and (eqv? a 0) (or (carrier? b) (procedure? b))) b]
  [(and (eqv? b 0) (or (carrier? a) (procedure? a))) a])

(define (add-structures a b)
  (cond [(eqv? a 0) b]
        [(eqv? b 0) a]
        [else (structure-add add a b raise-sum)]))

(define (raise-sum a b) (raise-inapplicable generic:+ a b))

(define-variadic g:+ + add [() 0] [(a) (add a 0)])

(define-record generic:+ + g:+)

(define-binary (subtract a b) generic:- fl- - e:- subtract-structures
  [(and (structure? a) (structure? b)) (subtract-structures a b)])

(define (subtract-structures a b)
  (cond [(eqv? a 0) (multiply -1 b)]
        [(eqv? b 0) a]
        [else (structure-add subtract a b raise-difference)]))

(define (raise-difference a b) (raise-inapplicable generic:- a b))

(define-variadic g:- - subtract [(a) (negate a)])

(define (negate a)
  (cond [(number? a) (- a)]
        [(carrier? a) (multiply -1 a)]
        [(pointwise? a) (compose-unary generic:negate a)]
        [(arithmetic-value? a) (multiply -1 a)]
        [else (raise-inapplicable generic:negate a)]))

(define-named g:negate negate (lambda (a) (negate a)))

(define-record generic:negate negate negate)

(define-record generic:- - g:-)

;; ---------------------------------------------------------------------------
;; Products

(define-binary (multiply a b) generic:* fl* * e:* multiply-structures
  [(and (structure? a) (structure? b)) (multiply-structures a b)]
  [(and (eqv? a 1) (procedure? b)) b]
  [(and (eqv? b 1) (procedure? a)) a])

(define (multiply-structures a b)
  (structure-multiply add multiply a b raise-product raise-unlike-products))

(define (raise-product a b) (raise-inapplicable generic:* a b))
(define (raise-unlike-products a b)
  (raise-inapplicable-because
   generic:* "they contract, but the products of their components are of different shapes" a b))

(define-variadic g:* * multiply [() 1] [(a) (multiply 1 a)])

(define-record generic:* * g:*)

;; The square of a tuple is the sum of the squares of its components (SICM
;; p. 519): a scalar, unlike (* v v), which is the outer product.  So the square
;; of a function squares its values.
(define-named g:square square
  (lambda (a)
    (cond [(flonum? a) (fl* a a)]
          [(carrier? a) ((kind-unary (carrier-kind a)) generic:square a)]
          [(number? a) (* a a)]
          [(tuple? a) (sum-of-squares (tuple-elements a))]
          [(pointwise? a) (compose-unary generic:square a)]
          [(arithmetic-value? a) (multiply a a)]
          [else (raise-inapplicable generic:square a)])))

(define (sum-of-squares elements)
  (for/fold ([sum 0]) ([x (in-vector elements)]) (add sum (g:square x))))

(define-named g:cube cube
  (lambda (a)
    (cond [(pointwise? a) (compose-unary generic:cube a)]
          [(arithmetic-value? a) (multiply a (g:square a))]
          [else (raise-inapplicable generic:cube a)])))

(define-record generic:square square g:square)
(define-record generic:cube cube g:cube)

;; ---------------------------------------------------------------------------
;; Quotients

(define-binary (divide a b) generic:/ fl/ / e:/ divide-structures)

(define (divide-structures a b)
  (if (tuple? b)
      (raise-inapplicable generic:/ a b)
      (structure-map (lambda (x) (divide x b)) (adopt a))))

(define-variadic g:/ / divide [(a) (divide 1 a)])

(define-named g:invert invert (lambda (a) (divide 1 a)))

(define-record generic:/ / g:/)

;; Every record above, for a test that checks each derivative.
(define arithmetic-operations
  (list generic:+ generic:- generic:* generic:/ generic:negate generic:square generic:cube))
