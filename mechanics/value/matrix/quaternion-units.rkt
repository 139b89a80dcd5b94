#lang racket/base
;; The units i, j, k of the quaternions as 4 by 4 matrices (SICM 2.12, p. 186): the quaternion
;; (r, x, y, z) is r 1 + x i + y j + z k, a matrix with these four numbers in its first row.
;; In this form a unit acts on the tuple of a quaternion's four parts.

(require "matrix.rkt")

(provide q:i q:j q:k)

(define q:i
  (matrix-by-rows '(0 1 0 0) '(-1 0 0 0) '(0 0 0 -1) '(0 0 1 0)))

(define q:j
  (matrix-by-rows '(0 0 1 0) '(0 0 0 1) '(-1 0 0 0) '(0 -1 0 0)))

(define q:k
  (matrix-by-rows '(0 0 0 1) '(0 0 -1 0) '(0 1 0 0) '(-1 0 0 0)))
