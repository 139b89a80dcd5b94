#lang racket/base
;; Characteristic polynomials and eigenvalues.
;;
;; Zeros first: rows and columns that reach one another form a block, and the
;; eigenvalues are those of the blocks.  A block of one row is its own; (a b; c d)
;; has (τ ± √((a - d)² + 4 b c))/2, with the trace τ.  Of flonums, one of the two
;; may lose its digits in the difference; it is the determinant over the other.
;; Greater blocks lead to equations of higher degree: those of flonums are left to
;; the algorithms of numeric/, others are refused.

(require racket/flonum racket/lazy-require
         "linear.rkt" "linear-algebra.rkt"
         (only-in "signature.rkt" scalar?)
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt")

(provide characteristic-polynomial eigenvalues)

(lazy-require
 ["../numeric/eigenvalues.rkt" (real-matrix-eigenvalues)]
 ["../numeric/symmetric-eigenvalues.rkt" (symmetric-eigenvalues)])

;; |x - m|, a polynomial in x: a scalar, or a square matrix.
(define (characteristic-polynomial m x)
  (define coefficients (rows-characteristic (square 'characteristic-polynomial m)))
  (for/fold ([value 0]) ([c (in-list coefficients)])
    (g:+ (g:* value x) c)))

(define (square who m)
  (or (square-entries who m)
      (and (scalar? m) (vector (vector m)))
      (raise
       (exn:fail:contract
        (format "~a: expected a square matrix or tuple of tuples; given ~a" who
                (describe-with-value m))
        (current-continuation-marks)))))

;; A list, each as often as it is a root of the characteristic polynomial.
(define (eigenvalues m)
  (apply append
         (for/list ([block (in-list (rows-diagonal-blocks (square 'eigenvalues m)))])
           (case (vector-length block)
             [(1) (list (vector-ref (vector-ref block 0) 0))]
             [(2) (two-eigenvalues block)]
             [else (or (numeric-eigenvalues block)
                       (raise-degree m (vector-length block)))]))))

(define (two-eigenvalues block)
  (define (entry i j) (vector-ref (vector-ref block i) j))
  (define trace (g:+ (entry 0 0) (entry 1 1)))
  (define root
    (g:sqrt (g:+ (g:square (g:- (entry 0 0) (entry 1 1)))
                 (g:* 4 (entry 0 1) (entry 1 0)))))
  (define plus (g:/ (g:+ trace root) 2))
  (define minus (g:/ (g:- trace root) 2))
  (cond [(not (and (flonum? root) (real? trace))) (list plus minus)]
        [(> trace 0) (list plus (/ (rows-determinant block) plus))]
        [(< trace 0) (list (/ (rows-determinant block) minus) minus)]
        [else (list plus minus)]))

;; Of real numbers, some of them flonums: from the least to the greatest, by real part
;; and then by imaginary part.  Exact numbers are kept exact, and so refused.
(define (numeric-eigenvalues block)
  (define n (vector-length block))
  (define entries (for*/list ([row (in-vector block)] [x (in-vector row)]) x))
  (and (andmap real? entries)
       (ormap flonum? entries)
       (let ([m (for/flvector #:length (* n n) ([x (in-list entries)])
                  (real->double-flonum x))])
         (if (symmetric? m n)
             (let-values ([(found vectors) (symmetric-eigenvalues m n)])
               (for/list ([x (in-flvector found)]) x))
             (let ([found (real-matrix-eigenvalues m n)])
               (and found (sort found before?)))))))

(define (symmetric? m n)
  (for*/and ([i (in-range n)] [j (in-range i)])
    (fl= (flvector-ref m (+ (* i n) j)) (flvector-ref m (+ (* j n) i)))))

(define (before? a b)
  (or (< (real-part a) (real-part b))
      (and (= (real-part a) (real-part b)) (< (imag-part a) (imag-part b)))))

(define (raise-degree m n)
  (raise
   (exn:fail:contract
    (format (string-append
             "eigenvalues: the zeros of the matrix leave a block of ~a rows; "
             "formulas are for 1 and 2\n"
             "  the eigenvalues are the zeros of (characteristic-polynomial m 'x);\n"
             "  those of flonums are found: (eigenvalues (exact->inexact m))\n"
             "  matrix: ~a")
            n (value->text m))
    (current-continuation-marks))))
