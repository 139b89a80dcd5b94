#lang racket/base
;; What has three components, as the procedures of rigid bodies take it: an up tuple or, since
;; the book writes vectors as matrices too, a matrix of one column.

(require "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt"
         "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide three check-angles)

;; -> its components, three values
(define (three who what x)
  (define v (if (column-of-3? x) (column-matrix->up x) x))
  (unless (and (tuple? v) (= (s:length v) 3))
    (complain who "expected ~a, a tuple of 3 components; given ~a~a"
              what (describe-with-value x) (list-hint x "(up x y z)")))
  (apply values (structure->list v)))

(define (column-of-3? x) (and (matrix? x) (= (m:num-rows x) 3) (= (m:num-cols x) 1)))

;; Euler angles, in the book's order
(define (check-angles who x) (three who "the Euler angles (up theta phi psi)" x))
