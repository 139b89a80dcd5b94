#lang racket/base
;; Are two values the same, as far as a test can tell?
;;
;; Numbers to a relative tolerance, expressions at seeded points, containers
;; component by component, series by their first terms, functions by their value at
;; a symbol, operators by what they make of an unknown function.  A scalar is the
;; same as the constant function, the multiple of the identity matrix or operator,
;; or the series of one term that it stands for.

(require (for-syntax racket/base)
         mechanics/algebra/expression/expression
         (only-in mechanics/generic/arithmetic g:*)
         (only-in mechanics/generic/irrational irrational?)
         mechanics/generic/up-down
         mechanics/generic/function
         mechanics/value/matrix/matrix
         mechanics/value/operator
         mechanics/value/series/series
         mechanics/calculus/perturbed-value
         mechanics/calculus/dual
         mechanics/calculus/literal-function
         "checks.rkt" "close.rkt" "numeric-value.rkt")

(provide
 same?         ; (same? a b [tolerance])
 close-to      ; (close-to tolerance) -> such a predicate
 check-same)   ; (check-same actual expected [tolerance]) : a check

(define points '(1 2 3))
(define terms 5)

(define ((close-to tolerance) a b) (same? a b tolerance))

(define (same? a b [tolerance 1e-9])
  (define (same-parts? as bs)
    (and (= (length as) (length bs))
         (for/and ([x (in-list as)] [y (in-list bs)]) (same? x y tolerance))))
  (cond [(and (a-number? a) (a-number? b)) (close? a b tolerance)]
        [(or (series? a) (series? b))
         (for/and ([k (in-range terms)]) (same? (term a k) (term b k) tolerance))]
        [(and (expression? a) (expression? b))
         (for/and ([p (in-list points)])
           (close? (numeric-value a p) (numeric-value b p) tolerance))]
        [(and (tuple? a) (tuple? b))
         (and (eq? (structure-orientation (adopt a)) (structure-orientation (adopt b)))
              (same-parts? (parts a) (parts b)))]
        [(and (matrix? a) (matrix? b))
         (same-parts? (map vector->up (vector->list (matrix-rows a)))
                      (map vector->up (vector->list (matrix-rows b))))]
        [(and (or (dual? a) (dual? b)) (scalar? a) (scalar? b))
         (define tag (perturbed-tag (outermost a b)))
         (and (same? (primal-part a tag) (primal-part b tag) tolerance)
              (same? (tangent-part a tag) (tangent-part b tag) tolerance))]
        [(or (operator? a) (operator? b)) (same? (image a) (image b) tolerance)]
        [(or (pointwise? a) (pointwise? b)) (same? (value a) (value b) tolerance)]
        [(and (matrix? a) (scalar? b)) (same? a (multiple b a) tolerance)]
        [(and (scalar? a) (matrix? b)) (same? (multiple a b) b tolerance)]
        [else (equal? a b)]))

(define (a-number? x) (or (number? x) (irrational? x)))

(define unknown (literal-function 'unknown))
(define (image x) (if (operator? x) (x unknown) (g:* x unknown)))
(define (value x) (if (pointwise? x) (x 'argument) x))
(define (multiple a m) (g:* a (identity-matrix (m:num-rows m))))

(define (term x k)
  (cond [(series? x) (series-term x k)]
        [(eqv? k 0) x]
        [else 0]))

(define (parts s) (vector->list (structure-elements (adopt s))))
(define (scalar? x) (or (dual? x) (expression? x)))

;; A syntax, so that a failure is told where it stands.
(define-syntax (check-same stx)
  (syntax-case stx ()
    [(_ actual expected) (syntax/loc stx (check-same-to actual expected 1e-9))]
    [(_ actual expected tolerance) (syntax/loc stx (check-same-to actual expected tolerance))]))

(define-check (check-same-to actual expected tolerance)
  (with-check-info (['actual actual] ['expected expected])
    (unless (same? actual expected tolerance) (fail-check))))

(module+ test
  (require mechanics/generic/arithmetic mechanics/generic/elementary
           (only-in mechanics/value/compose constant-function)
           mechanics/calculus/derivative
           mechanics/value/series/series-access)

  (test-case "what is the same is seen to be"
    (check-true (same? 1/3 (/ 1.0 3)))
    (check-true (same? (up 1 (g:+ 'a 'b)) (vector 1.0 (g:+ 'b 'a))))
    (check-true (same? g:square (lambda (x) (g:* x x))))
    (check-true (same? (g:* D D) (g:expt D 2)))
    (check-true (same? (perturb 9 'a) (g:+ 0 (perturb 9 'a))))
    (check-true (same? 2 (constant-function 2)))
    (check-true (same? (matrix-by-rows '(2 0) '(0 2)) 2))
    (check-true (same? 2 (g:+ 2 (g:- D D))))
    (check-true (same? (power-series 2 0) 2))
    (check-true (same? (power-series 1 1) (g:/ (power-series 1 2 1) (power-series 1 1)))))

  (test-case "what is not, is not"
    (check-false (same? 1 1.00001))
    (check-false (same? (up 1 2) (down 1 2)))
    (check-false (same? (up 1 2) (up 1 2 3)))
    (check-false (same? (up 1 2) 3))
    (check-false (same? (matrix-by-rows '(1 2)) (matrix-by-rows '(1 3))))
    (check-false (same? g:sin g:cos))
    (check-false (same? D (g:expt D 2)))
    (check-false (same? D 1))
    (check-false (same? (power-series 1 2 3) (power-series 1 2 4)))
    (check-false (same? 2 g:sin))
    (check-false (same? (matrix-by-rows '(2 0) '(1 2)) 2))
    (check-false (same? (perturb 9 'a) 'a))
    (check-false (same? (perturb 9 'a) (make-dual 9 'a 2)))))
