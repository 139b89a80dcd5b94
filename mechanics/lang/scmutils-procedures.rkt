#lang racket/base
;; Procedures of scmutils for which `mechanics` has others.

(require "../error/complain.rkt"
         "../generic/on-demand.rkt" "../generic/wrong-argument.rkt"
         (only-in "../lagrangian/local-tuple.rkt" coordinate)
         "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide column-matrix row-matrix column-matrix->vector row-matrix->vector literal-matrix
         state->n-dof)

(provide-on-demand
 ["../compile/definite-integral.rkt" definite-integral-with-tolerance]
 ["../lagrangian/generalized-LE.rkt" generalized-LE]
 ["../search/minimize.rkt" brent-min golden-section-min]
 ["../search/find-root.rkt" newton-search zbrent]
 ["../search/numeric-derivative.rkt" richardson-derivative]
 ["../value/special-functions.rkt" bessj bessj0 bessj1])

(define (state->n-dof local) (dimension (coordinate local)))

;; ---------------------------------------------------------------------------
;; Matrices

(define (column-matrix . entries) (up->column-matrix (list->up entries)))
(define (row-matrix . entries) (down->row-matrix (list->down entries)))

(define (column-matrix->vector m) (structure->vector (column-matrix->up m)))
(define (row-matrix->vector m) (structure->vector (row-matrix->down m)))

;; A matrix of symbols: row i and column j hold name^i_j.
(define (literal-matrix name rows columns)
  (check-argument 'literal-matrix symbol? name "a quoted name, such as 'A")
  (unless (andmap exact-positive-integer? (list rows columns))
    (complain 'literal-matrix "expected a number of rows and one of columns; given ~s and ~s"
              rows columns))
  (m:generate rows columns
              (lambda (i j) (string->symbol (format "~a^~a_~a" name i j)))))
