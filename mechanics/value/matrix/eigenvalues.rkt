#lang racket/base
;; Characteristic polynomials and eigenvalues.
;;
;; Zeros first: rows and columns that reach one another form a block, and the
;; eigenvalues are those of the blocks.  A block of one row is its own; (a b; c d)
;; has (τ ± √((a - d)² + 4 b c))/2, with the trace τ; of exact numbers that is exact where it is
;; real, of others it has all digits (surd.rkt).  Greater blocks lead to equations of higher
;; degree: those of flonums are left to the algorithms of numeric/, others are refused.
;;
;; How much roundings change eigenvalues, those of a neighbor tell: the transposed matrix, its
;; entries changed by a few roundings.

(require racket/flonum
         racket/list
         "linear-algebra.rkt" "row-systems.rkt" "surd.rkt" "unsure-digits.rkt"
         "../simplify.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/operation.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt" "../../generic/irrational.rkt" "../../generic/on-demand.rkt"
         "../../generic/scalar.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/constants.rkt" "../../numeric/finite-number.rkt"
         "../../numeric/flvector.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide characteristic-polynomial eigenvalues
         ;; for eigenvectors and roots
         (struct-out sure) spectrum exact-spectrum exact-value decimal)

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
  (define found (spectrum 'eigenvalues m))
  (note-unsure 'eigenvalues
               (for/list ([x (in-list found)] #:when (unsure? x))
                 (with-bound (sure-value x) (sure-within x)))
               advice)
  (map sure-value found))

(define advice
  "of exact entries (polynomial-roots (characteristic-polynomial m 'x) 'x) has all digits")

;; An eigenvalue, and about how much roundings change it
(struct sure (value within) #:authentic)

(define (unsure? x)
  (and (not (eqv? (sure-within x) 0)) (few-digits? (sure-within x) (magnitude (sure-value x)))))

;; -> a list of sure
(define (spectrum who m)
  (append-map (lambda (block) (block-spectrum who m block))
              (rows-diagonal-blocks (square who m))))

(define (block-spectrum who m block)
  (define (exactly x) (sure x 0))
  (cond [(= (vector-length block) 1) (list (exactly (entry block 0 0)))]
        [(flonums? block) (numeric-spectrum who m block)]
        [(not (= (vector-length block) 2)) (raise-degree who m (vector-length block))]
        [(all-entries? rational? block)
         (for/list ([x (in-list (two-numbers block))])
           (exactly (or (and (all-entries? exact? block) (exact-value x)) (decimal who x))))]
        [else (map exactly (two-eigenvalues block))]))

;; Of a matrix of rational numbers, where its blocks have no more than two rows: rational numbers
;; or surds
(define (exact-spectrum who m)
  (append*
   (for/list ([block (in-list (rows-diagonal-blocks (square who m)))])
     (case (vector-length block)
       [(1) (list (entry block 0 0))]
       [(2) (two-numbers block)]
       [else (raise-degree who m (vector-length block))]))))

(define (two-numbers block)
  (define-values (a b c d) (four-entries inexact->exact block))
  (quadratic-roots (+ a d) (- (* a d) (* b c))))

(define (four-entries f block)
  (values (f (entry block 0 0)) (f (entry block 0 1)) (f (entry block 1 0)) (f (entry block 1 1))))

;; The exact number that a surd or a rational number is; #f of one that is complex, or has a root
;; that is not taken apart
(define (exact-value x)
  (define value (if (surd? x) (g:+ (surd-p x) (g:* (surd-q x) (g:sqrt (surd-D x)))) x))
  (and (exact-real? value) value))

;; The decimal of a surd; a rational number as it is
(define (decimal who x)
  (define z (if (surd? x) (exact->inexact (surd->number x)) x))
  (if (< (magnitude z) +inf.0)
      z
      (complain who "there are values beyond 1.8e308, where decimals end")))

(define (two-eigenvalues block)
  (define-values (a b c d) (four-entries values block))
  (define trace (g:+ a d))
  (define root (without-signs (g:sqrt (g:+ (g:square (g:- a d)) (g:* 4 b c)))))
  (list (g:/ (g:+ trace root) 2) (g:/ (g:- trace root) 2)))

;; The root comes with both signs, so that x does for a factor |x| of it.
(define (without-signs root)
  (define simple (if (node? root) (simplify root) root))
  (define factors (if (headed? simple op:*) (node-args simple) (list simple)))
  (define (size? f) (headed? f op:abs))
  (if (ormap size? factors)
      (apply g:* (map (lambda (f) (if (size? f) (car (node-args f)) f)) factors))
      root))

;; Real numbers, some of them flonums: exact ones alone are kept exact.
(define (flonums? block)
  (and (all-entries? real? block)
       (not (all-entries? exact? block))))

;; Of three or more from the least to the greatest, by real part and then by imaginary
;; part.
(define (numeric-spectrum who m block)
  (define n (vector-length block))
  (define v (rows->flvector block))
  (check-finite m v)
  (cond [(= n 2)
         (for/list ([x (in-list (two-numbers block))])
           (define z (decimal who x))
           (sure z (* epsilon (magnitude z))))]
        [else
         (define find (if (symmetric? block) symmetric-values real-matrix-eigenvalues))
         (define found (or (find v n) (raise-not-separate m)))
         (define others (or (find (neighbor v n) n) found))
         (for/list ([x (in-list (sort found before?))])
           (sure x (for/fold ([least +inf.0]) ([y (in-list others)])
                     (min least (magnitude (- x y))))))]))

(define (symmetric-values v n)
  (define-values (found vectors) (symmetric-eigenvalues v n))
  (flvector->list found))

;; Symmetric if v is.
(define (neighbor v n)
  (for*/flvector #:length (* n n) ([i (in-range n)] [j (in-range n)])
    (define change (flsin (->fl (+ 1 i j (* 3 i j)))))
    (fl* (flvector-ref v (+ (* j n) i)) (fl+ 1.0 (fl* (fl* 16.0 epsilon) change)))))

(define (check-finite m v)
  (for ([x (in-flvector v)])
    (unless (finite? x)
      (complain-showing 'eigenvalues "expected a matrix of finite numbers"
                        "entry" x
                        "matrix" m))))

(define (before? a b)
  (or (< (real-part a) (real-part b))
      (and (= (real-part a) (real-part b)) (< (imag-part a) (imag-part b)))))

(define (raise-not-separate m)
  (raise-not-convergent 'eigenvalues (format "they do not separate\n  matrix: ~a" (value->text m))
                        m #f #:show? #f))

(define (raise-degree who m n)
  (complain who
            (string-append
             "the zeros of the matrix leave a block of ~a rows; formulas are for 1 and 2\n"
             "  the eigenvalues are the zeros of (characteristic-polynomial m 'x);\n"
             "  those of flonums are found: (~a (exact->inexact m))\n"
             "  matrix: ~a")
            n who (value->text m)))
