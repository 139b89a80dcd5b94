#lang racket/base
;; Programs: what is written once, what is computed beforehand, what is dropped.

(require mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/compile/program
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         "../support/checks.rkt")

(define (refuse e) (raise (list 'no-value e)))

(define (program-of inputs . es) (expressions->program inputs es refuse))

(define (operations p)
  (for/list ([i (in-vector (program-instructions p))]) (instruction-operation i)))

(test-case "equal subexpressions are computed once, however they were built"
  (define p (program-of '(x y) (g:+ (g:sin (g:* 'x 'y)) (g:square (g:sin (g:* 'y 'x))))))
  (check-equal? (operations p) '(multiply sin multiply add)))

(test-case "numbers are combined exactly before the code runs"
  (check-equal? (program-of '(x) (g:* 1/3 3 'x)) (program 1 (vector) (vector (place 0))))
  (check-equal? (operations (program-of '(x) (g:+ (g:* 2 3 'x) (g:exp 0) -1))) '(multiply)))

(test-case "exact and inexact numbers of one value make one instruction"
  (check-equal? (operations (program-of '(x) (g:sin (g:* 3 'x)) (g:cos (g:* 3.0 'x))))
                '(multiply sin cos)))

(test-case "a product with a number takes in the number of another"
  (define p (program-of '(x y) (g:* 1/2 (g:+ (g:* 2.0 (g:sin 'x)) 0)) (g:* 1.0 (g:cos 'y))))
  (check-equal? (operations p) '(sin cos)))

(test-case "signs become subtractions, and cancel"
  (check-equal? (operations (program-of '(x y) (g:+ 'x (g:* -1 'y)))) '(subtract))
  (check-equal? (operations (program-of '(x y) (g:* (g:negate 'x) (g:negate 'y)))) '(multiply)))

(test-case "multiples of one value are added as numbers"
  (define-values (a b) (values (g:sin 'x) (g:* 2 (g:sin 'x))))
  (define (sums f) (operations (program-of '(x) f)))
  (check-equal? (sums (g:+ (g:* 3 a) (g:+ (g:* 1/2 b) 0))) '(sin multiply))
  (check-equal? (sums (g:- (g:* 1.5 a) (g:* 1/2 a))) '(sin))
  (check-equal? (sums (g:+ (g:negate a) (g:* 1/2 b))) '())
  (check-equal? (sums (g:- (g:* 3 a) (g:* 3/2 b))) '()))

(test-case "what is added and subtracted again is not computed"
  (define (sums f) (operations (program-of '(x y z) f)))
  (define-values (a b c) (values (g:sin 'x) (g:sin 'y) (g:sin 'z)))
  (check-equal? (sums (g:- (g:+ (g:* 2 a) b) (g:+ (g:* 2 a) c))) '(sin sin subtract))
  (check-equal? (sums (g:- (g:+ b 'x) (g:* 2 (g:+ (g:* 1/2 b) 0)))) '())
  (check-equal? (sums (g:+ (g:- a b) (g:* 3 (g:* 1/3 b)))) '(sin))
  (check-equal? (sums (g:- (g:+ a b) (g:- a c))) '(sin sin add)))

(test-case "whole and half powers are multiplications and a square root"
  (check-equal? (operations (program-of '(x) (g:expt 'x 5))) '(multiply multiply multiply))
  (check-equal? (operations (program-of '(x) (g:expt 'x -2))) '(multiply divide))
  (check-equal? (operations (program-of '(x) (g:expt 'x 3/2))) '(sqrt multiply))
  (check-equal? (operations (program-of '(x n) (g:expt 'x 'n))) '(expt))
  (for ([n '(65 -65 129/2 -129/2)])
    (check-equal? (operations (program-of '(x) (g:expt 'x n))) '(expt)))
  (check-equal? (length (operations (program-of '(x) (g:expt 'x -64)))) 7)
  (check-equal? (operations (program-of '(x) (g:* 'x (g:expt 2 1/3)))) '(multiply)))

(test-case "what no output needs is left out"
  (define p (program-of '(x) (g:- (g:sin 'x) (g:sin 'x)) (g:cos 'x)))
  (check-equal? (operations p) '(cos))
  (check-equal? (program-outputs p) (vector 0 (place 1))))

(test-case "symbols and functions without a value are refused"
  (check-exn (lambda (x) (equal? x '(no-value m)))
             (lambda () (program-of '(x) (g:* 'm 'x))))
  (check-exn list? (lambda () (program-of '(x) (make-node (make-literal-head 'V) '(x)))))
  (check-exn list? (lambda () (program-of '(x) (g:* 'x (g:sqrt -1))))))
