#lang racket/base
;; Eigenvalues and eigenvectors of symmetric matrices of flonums, by Jacobi's rotations.
;;
;; A turn in the plane of two coordinates p and q makes the entry a_pq vanish; the sum
;; of the squares off the diagonal falls by 2 a_pq², and what was cleared before comes
;; back smaller.  Sweep after sweep over all pairs, the convergence is quadratic at the
;; end: six to ten sweeps do for any size.  Of all methods this one keeps the small
;; eigenvalues best (Demmel and Veselić 1992): for positive definite matrices each has a
;; relative error of some roundings, which is what slow modes beside fast ones need.

(require racket/flonum
         racket/list
         "../constants.rkt")

(provide symmetric-eigenvalues)

;; a : flvector of the n² entries of a symmetric matrix, row by row; it is not changed.
;; -> the eigenvalues from the least to the greatest in an flvector, and in an flvector
;;    of n² entries the eigenvectors of unit length, one in each row, in the same order
(define (symmetric-eigenvalues a n)
  (define m (flvector-copy a))
  (define vectors (unit n))
  (let sweep ([rest 60])
    (when (and (for*/fold ([turned? #f]) ([p (in-range n)] [q (in-range (+ p 1) n)])
                 (or (turn! m vectors n p q) turned?))
               (> rest 0))
      (sweep (- rest 1))))
  (in-order m vectors n))

(define (unit n)
  (define m (make-flvector (* n n)))
  (for ([i (in-range n)]) (flvector-set! m (* i (+ n 1)) 1.0))
  m)

;; Makes the entry of row p and column q vanish, unless it is nothing beside the
;; diagonal: beside the geometric mean, so that small eigenvalues count as much.
(define (turn! m vectors n p q)
  (define off (flvector-ref m (+ (* p n) q)))
  (define app (flvector-ref m (* p (+ n 1))))
  (define aqq (flvector-ref m (* q (+ n 1))))
  (and (not (fl= off 0.0))
       (fl> (flabs off) (fl* (fl* 0.5 epsilon) (fl* (flsqrt (flabs app)) (flsqrt (flabs aqq)))))
       (let*-values ([(tangent) (small-tangent (fl/ (fl- aqq app) (fl* 2.0 off)))]
                     [(c) (fl/ 1.0 (flsqrt (fl+ 1.0 (fl* tangent tangent))))]
                     [(s) (fl* tangent c)])
         (mix-columns! m n p q c s)
         (mix-rows! m n p q c s)
         (mix-rows! vectors n p q c s)
         (flvector-set! m (* p (+ n 1)) (fl- app (fl* tangent off)))
         (flvector-set! m (* q (+ n 1)) (fl+ aqq (fl* tangent off)))
         (flvector-set! m (+ (* p n) q) 0.0)
         (flvector-set! m (+ (* q n) p) 0.0)
         #t)))

;; The smaller root of t² + 2 t x - 1, the tangent of the angle to turn by: twice the
;; angle has the cotangent x.
(define (small-tangent x)
  (define t (fl/ 1.0 (fl+ (flabs x) (flsqrt (fl+ 1.0 (fl* x x))))))
  (if (fl< x 0.0) (fl- 0.0 t) t))

(define (mix-rows! m n p q c s)
  (for ([k (in-range n)]) (mix! m (+ (* p n) k) (+ (* q n) k) c s)))

(define (mix-columns! m n p q c s)
  (for ([k (in-range n)]) (mix! m (+ (* k n) p) (+ (* k n) q) c s)))

(define (mix! m i j c s)
  (define x (flvector-ref m i))
  (define y (flvector-ref m j))
  (flvector-set! m i (fl- (fl* c x) (fl* s y)))
  (flvector-set! m j (fl+ (fl* s x) (fl* c y))))

(define (in-order m vectors n)
  (define (value i) (flvector-ref m (* i (+ n 1))))
  (define order (sort (range n) < #:key value))
  (values (for/flvector #:length n ([i (in-list order)]) (value i))
          (for*/flvector #:length (* n n) ([i (in-list order)] [k (in-range n)])
            (flvector-ref vectors (+ (* i n) k)))))
