#lang racket/base
;; Eigenvalues and eigenvectors of symmetric matrices of flonums, by Jacobi's rotations.
;;
;; A turn in the plane of two coordinates p and q makes the entry a_pq vanish; the sum
;; of the squares off the diagonal falls by 2 a_pq², and entries cleared before come
;; back smaller.  Sweep after sweep over all pairs, the convergence is quadratic at the
;; end: six to ten sweeps do for any size.  Of all methods this one keeps the small
;; eigenvalues best (Demmel and Veselić 1992): for positive definite matrices each has a
;; relative error of some roundings, as slow modes beside fast ones need.

(require racket/flonum
         racket/list
         "Jacobi-rotation.rkt"
         "../constants.rkt" "../flvector.rkt")

(provide symmetric-eigenvalues)

;; a : flvector of the n² entries of a symmetric matrix, row by row; it is not changed.
;; -> the eigenvalues from the least to the greatest, an flvector, and the eigenvectors of unit
;;    length in the same order, a list of flvectors
(define (symmetric-eigenvalues a n)
  (define m (flvector-copy a))
  (define vectors (build-vector n (lambda (i) (unit-flvector i n))))
  (turn-all-pairs! n (lambda (p q) (turn! m vectors n p q)))
  (define (value i) (flvector-ref m (* i (+ n 1))))
  (define order (sort (range n) < #:key value))
  (values (for/flvector #:length n ([i (in-list order)]) (value i))
          (for/list ([i (in-list order)]) (vector-ref vectors i))))

;; Makes the entry of row p and column q vanish, unless it is negligible beside the geometric mean
;; of the diagonal's entries, by which small eigenvalues count as much as great ones.
;; -> was it turned?
(define (turn! m vectors n p q)
  (define off (flvector-ref m (+ (* p n) q)))
  (define app (flvector-ref m (* p (+ n 1))))
  (define aqq (flvector-ref m (* q (+ n 1))))
  (define turned?
    (and (not (fl= off 0.0))
         (fl> (flabs off)
              (fl* (fl* 0.5 epsilon) (fl* (flsqrt (flabs app)) (flsqrt (flabs aqq)))))))
  (when turned?
    (define-values (tangent c s) (rotation (fl/ (fl- aqq app) (fl* 2.0 off))))
    (for ([k (in-range n)])
      (mix! m (+ (* k n) p) m (+ (* k n) q) c s))
    (for ([k (in-range n)])
      (mix! m (+ (* p n) k) m (+ (* q n) k) c s)
      (mix! (vector-ref vectors p) k (vector-ref vectors q) k c s))
    (flvector-set! m (* p (+ n 1)) (fl- app (fl* tangent off)))
    (flvector-set! m (* q (+ n 1)) (fl+ aqq (fl* tangent off)))
    (flvector-set! m (+ (* p n) q) 0.0)
    (flvector-set! m (+ (* q n) p) 0.0))
  turned?)
