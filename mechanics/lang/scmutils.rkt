#lang racket/base
;; Names that scmutils has for what is called otherwise here, and small things that it makes
;; of others.

(require "../calculus/derivative.rkt" "../calculus/literal-function.rkt"
         "../error/complain.rkt"
         "../generic/compare.rkt" "../generic/describe.rkt" "../generic/wrong-argument.rkt"
         "../numeric/constants.rkt" "../numeric/finite-number.rkt"
         "../value/compose.rkt" "../value/rewrite.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt")

(provide
 (rename-out [D derivative] [constant-function constant]
             [literal-up literal-up-tuple] [literal-down literal-down-tuple]
             [factor factor-polynomial-expression]
             [matrix-by-columns matrix-by-cols] [m:generate matrix:generate]
             [identity-matrix m:make-identity] [null-space lu-null-space]
             [up->column-matrix vector->column-matrix] [down->row-matrix vector->row-matrix]
             [golden-ratio :phi] [epsilon *machine-epsilon*])
 floor->exact close-enuf?
 column-matrix row-matrix column-matrix->vector row-matrix->vector literal-matrix)

;; ---------------------------------------------------------------------------
;; Numbers

;; The greatest integer that is not greater, exact.
(define (floor->exact x)
  (define number (comparand x))
  (unless (finite? number) (complain-of-argument 'floor->exact "a real number" x))
  (inexact->exact (floor number)))

;; Do two numbers differ by no more than tolerance times half the sum of their sizes and
;; `scale`?
(define (close-enuf? a b [tolerance (* 10 epsilon)] [scale 1])
  (for ([x (in-list (list a b))])
    (unless (number? (comparand x))
      (complain 'close-enuf? "expected two numbers; given ~a" (describe-with-value x))))
  (define-values (x y) (values (comparand a) (comparand b)))
  (<= (magnitude (- x y))
      (* tolerance (+ (* 1/2 (+ (magnitude x) (magnitude y))) scale))))

;; ---------------------------------------------------------------------------
;; Matrices

(define (column-matrix . entries) (up->column-matrix (list->up entries)))
(define (row-matrix . entries) (down->row-matrix (list->down entries)))

(define (column-matrix->vector m) (structure->vector (column-matrix->up m)))
(define (row-matrix->vector m) (structure->vector (row-matrix->down m)))

;; A matrix of symbols: row i and column j hold name^i_j.
(define (literal-matrix name rows columns)
  (check-argument 'literal-matrix symbol? name "a quoted name, such as 'A")
  (for ([n (in-list (list rows columns))])
    (unless (exact-positive-integer? n)
      (complain 'literal-matrix "expected a number of rows and one of columns; given ~s and ~s"
                rows columns)))
  (m:generate rows columns
              (lambda (i j) (string->symbol (format "~a^~a_~a" name i j)))))
