#lang racket/base
;; Characteristic polynomials and eigenvalues.
;;
;; Zeros first: rows and columns that reach one another form a block, and the
;; eigenvalues are those of the blocks.  A block of one row is its own; (a b; c d)
;; has (τ ± √((a - d)² + 4 b c))/2, with the trace τ.  Of flonums, one of the two
;; may lose its digits in the difference; it is the determinant over the other.
;; Greater blocks lead to equations of higher degree: those of flonums are left to
;; the algorithms of numeric/, others are refused.

(require racket/flonum
         racket/list
         "linear-algebra.rkt" "row-systems.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt" "../../generic/on-demand.rkt" "../../generic/scalar.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/finite-number.rkt" "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt"
         "../../numeric/linear-algebra/matrix-scaling.rkt")

(provide characteristic-polynomial eigenvalues)

(require-on-demand
 ["../../numeric/linear-algebra/general-eigenvalues.rkt" real-matrix-eigenvalues]
 ["../../numeric/linear-algebra/symmetric-eigenvalues.rkt" symmetric-eigenvalues])

;; |x - m|, a polynomial in x: a scalar, or a square matrix.
(define (characteristic-polynomial m x)
  (define coefficients (rows-characteristic (square 'characteristic-polynomial m)))
  (for/fold ([value 0]) ([c (in-list coefficients)])
    (g:+ (g:* value x) c)))

(define (square who m)
  (or (square-entries who m)
      (and (scalar? m) (vector (vector m)))
      (complain-of-argument who "a square matrix or tuple of tuples" m)))

;; A list, each as often as it is a root of the characteristic polynomial.
(define (eigenvalues m)
  (append-map (lambda (block) (block-eigenvalues m block))
              (rows-diagonal-blocks (square 'eigenvalues m))))

(define (block-eigenvalues m block)
  (cond [(= (vector-length block) 1) (list (entry block 0 0))]
        [(flonums? block) (numeric-eigenvalues m block)]
        [(= (vector-length block) 2) (two-eigenvalues block)]
        [else (raise-degree m (vector-length block))]))

(define (two-eigenvalues block)
  (define-values (a b c d)
    (values (entry block 0 0) (entry block 0 1) (entry block 1 0) (entry block 1 1)))
  (define trace (g:+ a d))
  (define root (g:sqrt (g:+ (g:square (g:- a d)) (g:* 4 b c))))
  (define plus (g:/ (g:+ trace root) 2))
  (define minus (g:/ (g:- trace root) 2))
  (cond [(not (and (flonum? root) (real? trace))) (list plus minus)]
        [(> trace 0) (list plus (/ (rows-determinant block) plus))]
        [(< trace 0) (list (/ (rows-determinant block) minus) minus)]
        [else (list plus minus)]))

;; Real numbers, some of them flonums: exact ones alone are kept exact.
(define (flonums? block)
  (and (all-entries? real? block)
       (not (all-entries? exact? block))))

;; Of three or more from the least to the greatest, by real part and then by imaginary
;; part.
(define (numeric-eigenvalues m block)
  (define n (vector-length block))
  (define v (rows->flvector block))
  (check-finite m v)
  (cond [(= n 2) (two-numeric-eigenvalues v)]
        [(symmetric? v n)
         (define-values (found vectors) (symmetric-eigenvalues v n))
         (flvector->list found)]
        [else (sort (or (real-matrix-eigenvalues v n) (raise-not-separate m)) before?)]))

(define (two-numeric-eigenvalues v)
  (define unit (unit-of v))
  (define-values (a b c d) (apply values (flvector->list (in-units v unit))))
  (for/list ([x (in-list (two-eigenvalues (vector (vector a b) (vector c d))))]) (* unit x)))

(define (check-finite m v)
  (for ([x (in-flvector v)])
    (unless (finite? x)
      (complain-showing 'eigenvalues "expected a matrix of finite numbers"
                        "entry" x
                        "matrix" m))))

(define (symmetric? m n)
  (for*/and ([i (in-range n)] [j (in-range i)])
    (fl= (flvector-ref m (+ (* i n) j)) (flvector-ref m (+ (* j n) i)))))

(define (before? a b)
  (or (< (real-part a) (real-part b))
      (and (= (real-part a) (real-part b)) (< (imag-part a) (imag-part b)))))

(define (raise-not-separate m)
  (raise-not-convergent 'eigenvalues (format "they do not separate\n  matrix: ~a" (value->text m))
                        m #f #:show? #f))

(define (raise-degree m n)
  (complain 'eigenvalues
            (string-append
             "the zeros of the matrix leave a block of ~a rows; formulas are for 1 and 2\n"
             "  the eigenvalues are the zeros of (characteristic-polynomial m 'x);\n"
             "  those of flonums are found: (eigenvalues (exact->inexact m))\n"
             "  matrix: ~a")
            n (value->text m)))
