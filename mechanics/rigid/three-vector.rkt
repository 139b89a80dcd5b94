#lang racket/base
;; Vectors of three components, as the procedures of rigid bodies take them: up tuples or, since
;; the book writes vectors as matrices too, matrices of one column.

(require "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt"
         "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide three matrix-of? check-angles)

;; -> its components, three values
(define (three who what x)
  (define v (if (matrix-of? x 3 1) (column-matrix->up x) x))
  (unless (and (tuple? v) (= (s:length v) 3))
    (complain who "expected ~a, a tuple of 3 components; given ~a~a"
              what (describe-with-value x) (list-hint x "(up x y z)")))
  (apply values (structure->list v)))

;; Is x a matrix of so many rows and columns?
(define (matrix-of? x rows columns)
  (and (matrix? x) (= (m:num-rows x) rows) (= (m:num-cols x) columns)))

;; Euler angles, in the book's order
(define (check-angles who x) (three who "the Euler angles (up theta phi psi)" x))
