#lang racket/base
;; Roots of polynomials: up to degree 2 the eigenvalues of the matrix with the coefficients in
;; its last column,
;;
;;   0 −c₀
;;   1 −c₁      of x² + c₁ x + c₀;
;;
;; of a higher degree, with numbers as coefficients, decimals, found by numeric/.  Rational roots of
;; a polynomial with rational coefficients are recognized by these, tried exactly, and divided out.

(require racket/list
         "eigenvalues.rkt" "matrix.rkt" "unsure-digits.rkt"
         "../rewrite.rkt" "../simplify.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/scalar.rkt"
         "../../generic/sums-and-products.rkt" "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/optimization/complex-zeros.rkt")

(provide polynomial-roots)

;; The roots of a polynomial in the symbol x, each as often as its multiplicity.
(define (polynomial-roots p x)
  (check-argument 'polynomial-roots scalar? p "a polynomial")
  (check-argument 'polynomial-roots symbol? x "a symbol, the unknown")
  (roots (coefficients-in p x)))

;; Of the polynomial with these coefficients, from x⁰ on.
(define (roots coefficients)
  (define degree (sub1 (length coefficients)))
  (define leading (last coefficients))
  (cond [(= degree 0) '()]
        [(g:zero? (car coefficients)) (cons 0 (roots (cdr coefficients)))]
        [(and (andmap number? coefficients)
              (or (> degree 2) (not (andmap exact? coefficients))))
         (numeric-roots coefficients)]
        [(> degree 2) (raise-no-formula coefficients)]
        [else
         (define monic (for/list ([c (in-list (drop-right coefficients 1))])
                         (simplify (g:/ c leading))))
         (map simplify (map sure-value (spectrum 'polynomial-roots (companion monic))))]))

(define (companion coefficients)
  (define n (length coefficients))
  (m:generate n n (lambda (i j)
                    (cond [(= j (sub1 n)) (g:negate (list-ref coefficients i))]
                          [(= i (add1 j)) 1]
                          [else 0]))))

(define (numeric-roots coefficients)
  (define all-exact? (andmap exact? coefficients))
  (define found
    (or (complex-zeros (map inexact->exact coefficients))
        (complain 'polynomial-roots
                  "there are roots beyond 1.8e308 or next to 0, where decimals end")))
  (define-values (rational rest)
    (if all-exact? (rational-roots (map bounded-zero found) coefficients) (values '() '())))
  (cond [(pair? rational) (append rational (roots rest))]
        [else
         (unless all-exact? (note-rough found))
         (map bounded-zero found)]))

;; Decimal coefficients are known but for roundings.
(define (note-rough found)
  (note-unsure 'polynomial-roots
               (for*/list ([b (in-list found)]
                           [z (in-value (bounded-zero b))]
                           [within (in-value (* epsilon (bounded-change b)))]
                           #:when (few-digits? within (magnitude z)))
                 (with-bound z within))
               "coefficients that are exact numbers leave all digits"))

;; -> those of the decimals that are rational, and the coefficients without them
(define (rational-roots decimals coefficients)
  (for*/fold ([rational '()] [rest coefficients] #:result (values (reverse rational) rest))
             ([x (in-list decimals)] #:when (real? x))
    (define exact (inexact->exact x))
    (define near (rationalize exact (abs (* 4 (inexact->exact epsilon) exact))))
    (define-values (remainder quotient) (divided-by near rest))
    (if (zero? remainder) (values (cons near rational) quotient) (values rational rest))))

;; By x − root, after Horner -> remainder, and the quotient's coefficients
(define (divided-by root coefficients)
  (define found
    (for/fold ([found '()]) ([c (in-list (reverse coefficients))])
      (cons (if (null? found) c (+ c (* root (car found)))) found)))
  (values (car found) (cdr found)))

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
            (sub1 (length coefficients)) (value->text coefficients)))

(define (raise-no-polynomial p x)
  (complain 'polynomial-roots "expected a polynomial in ~a, of degree ~a at most; given ~a"
            (value->text x) most-powers (value->text p)))
