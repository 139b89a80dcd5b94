#lang racket/base
;; Roots of polynomials: the eigenvalues of the matrix with the coefficients in its last
;; column,
;;
;;   0 0 −c₀
;;   1 0 −c₁      of x³ + c₂ x² + c₁ x + c₀.
;;   0 1 −c₂
;;
;; Rational roots of a polynomial with rational coefficients are recognized by their
;; decimals, tried exactly, and divided out.

(require racket/list
         "eigenvalues.rkt" "matrix.rkt"
         "../rewrite.rkt" "../simplify.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/scalar.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/wrong-argument.rkt")

(provide polynomial-roots)

;; The roots of a polynomial in the symbol x, each as often as its multiplicity.
(define (polynomial-roots p x)
  (check-argument 'polynomial-roots scalar? p "a polynomial")
  (check-argument 'polynomial-roots symbol? x "a symbol, the unknown")
  (define coefficients (coefficients-in p x))
  (define leading (last coefficients))
  (roots (for/list ([c (in-list (drop-right coefficients 1))]) (simplify (g:/ c leading)))))

;; Of the monic polynomial with these coefficients below its highest power, from x⁰ on.
(define (roots coefficients)
  (cond [(null? coefficients) '()]
        [(g:zero? (car coefficients)) (cons 0 (roots (cdr coefficients)))]
        [(and (> (length coefficients) 2) (andmap number? coefficients))
         (numeric-roots coefficients)]
        [(> (length coefficients) 2) (raise-no-formula coefficients)]
        [else (map simplify (eigenvalues (companion coefficients)))]))

(define (companion coefficients)
  (define n (length coefficients))
  (m:generate n n (lambda (i j)
                    (cond [(= j (sub1 n)) (g:negate (list-ref coefficients i))]
                          [(= i (add1 j)) 1]
                          [else 0]))))

(define (numeric-roots coefficients)
  (define found (eigenvalues (companion (map exact->inexact coefficients))))
  (define rational (and (andmap exact? coefficients) (ormap (exact-root coefficients) found)))
  (if rational
      (cons rational (roots (divided-by coefficients rational)))
      found))

;; decimal root -> the rational one beside it, or #f
(define ((exact-root coefficients) decimal)
  (for*/first ([near (in-list '(1/1000000000 1/100000 1/1000))]
               [x (in-value (rationalize (inexact->exact (real-part decimal)) near))]
               #:when (zero? (value-at x coefficients)))
    x))

;; Horner's scheme -> the value of the polynomial at x, then the coefficients of its quotient by
;; the linear factor of x.
(define (horner x coefficients)
  (for/fold ([found '(1)]) ([c (in-list (reverse coefficients))])
    (cons (+ c (* x (car found))) found)))

(define (value-at x coefficients) (car (horner x coefficients)))
(define (divided-by coefficients x) (drop-right (cdr (horner x coefficients)) 1))

;; ---------------------------------------------------------------------------

;; From x⁰ on to the highest power.
(define (coefficients-in p x)
  (let next ([rest (simplify p)] [n 0] [found '()])
    (cond [(g:zero? rest)
           (when (null? found) (complain 'polynomial-roots "every number is a root of 0"))
           (reverse found)]
          [(> n most-powers) (raise-no-polynomial p x)]
          [else
           (define c (coefficient rest x n))
           (when (occurs? x c) (raise-no-polynomial p x))
           (next (simplify (g:- rest (g:* c (power x n)))) (add1 n) (cons c found))])))

(define (power x n) (g:for/product ([_ (in-range n)]) x))

(define most-powers 100)

(define (raise-no-formula coefficients)
  (complain 'polynomial-roots
            (string-append "of degree ~a and with symbols in the coefficients it has no formula; "
                           "(factor p) may find factors of lower degree\n  coefficients: ~a")
            (length coefficients) (value->text (append coefficients '(1)))))

(define (raise-no-polynomial p x)
  (complain 'polynomial-roots "expected a polynomial in ~a, of degree ~a at most; given ~a"
            (value->text x) most-powers (value->text p)))
