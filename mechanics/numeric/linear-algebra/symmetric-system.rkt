#lang racket/base
;; Symmetric systems, as mass matrices make them, for the inner loops of integration.
;;
;; A positive definite matrix is L Lᵀ (Cholesky), which takes half the time of elimination
;; and needs no pivots.  Row i of L follows from the rows above,
;;
;;     L_ij = (A_ij − Σ_{k<j} L_ik L_jk) / L_jj ,   L_ii² = A_ii − Σ_{k<i} L_ik² ,
;;
;; by products of rows.  They take the place of the lower triangle, with 1/L_ii on the
;; diagonal.  Where L_ii² is not positive beyond rounding the matrix is indefinite or nearly
;; singular: it is restored from its upper triangle and left to elimination.
;;
;; For a few unknowns loops are the greater part of that: small-symmetric-system.rkt.

(require racket/flonum
         racket/unsafe/ops
         "factored-system.rkt" "small-symmetric-system.rkt"
         "../unboxed-loop.rkt")

(provide solve-symmetric!)

;; m : n² entries, which are changed; exchanges : room, as solve-dense! needs it
;; b, the right-hand side, becomes the solution; of a singular m, all not-a-number.
(define (solve-symmetric! m n exchanges b)
  (unless (if (unsafe-fx<= n most-unknowns) (solve-small! m n b) (solve-by-rows! m n b))
    (solve-dense! m n exchanges b)))

;; -> is m positive definite?  If not, m is unchanged.
(define (solve-by-rows! m n b)
  (define diagonal (make-flvector n))
  (define rows (cholesky! m n diagonal))
  (define definite? (unsafe-fx= rows n))
  (if definite?
      (solve-by-triangle! m n b)
      (restore! m n diagonal rows))
  definite?)

;; diagonal : where that of m is saved -> how many rows are done, n if m is positive definite
(define (cholesky! m n diagonal)
  (let row ([i 0] [start 0])
    (cond
      [(unsafe-fx= i n) n]
      [else
       (define end (unsafe-fx+ start i))
       (define whole (at m end))
       (put! diagonal i whole)
       (let column ([j 0] [other 0])
         (when (unsafe-fx< j i)
           (let ([k (unsafe-fx+ start j)])
             (put! m k (unsafe-fl* (unsafe-fl- (at m k) (row-product m start other j))
                                   (at m (unsafe-fx+ other j))))
             (column (unsafe-fx+ j 1) (unsafe-fx+ other n)))))
       (define rest (unsafe-fl- whole (row-product m start start i)))
       (cond [(and (unsafe-fl> rest (unsafe-fl* least-part whole)) (unsafe-fl< rest +inf.0))
              (put! m end (unsafe-fl/ 1.0 (unsafe-flsqrt rest)))
              (row (unsafe-fx+ i 1) (unsafe-fx+ start n))]
             [else i])])))

;; Of the first n entries of the rows that begin at a and b; in four sums, for one would wait
;; for itself.
(define (row-product m a b n)
  (define end (unsafe-fx+ a n))
  (define most (unsafe-fx- end 3))
  (let loop ([a a] [b b] [w 0.0] [x 0.0] [y 0.0] [z 0.0])
    (define-syntax-rule (next sum k)
      (unsafe-fl+ sum (unsafe-fl* (at m (unsafe-fx+ a k)) (at m (unsafe-fx+ b k)))))
    (if (unsafe-fx< a most)
        (loop (unsafe-fx+ a 4) (unsafe-fx+ b 4) (next w 0) (next x 1) (next y 2) (next z 3))
        (let last ([a a] [b b] [sum (unsafe-fl+ (unsafe-fl+ w x) (unsafe-fl+ y z))])
          (if (unsafe-fx< a end)
              (last (unsafe-fx+ a 1) (unsafe-fx+ b 1)
                    (unsafe-fl+ sum (unsafe-fl* (at m a) (at m b))))
              sum)))))

(define (solve-by-triangle! m n b)
  (let down ([i 0] [start 0])
    (when (unsafe-fx< i n)
      (let column ([j 0] [rest (at b i)])
        (if (unsafe-fx< j i)
            (column (unsafe-fx+ j 1)
                    (unsafe-fl- rest (unsafe-fl* (at m (unsafe-fx+ start j)) (at b j))))
            (put! b i (unsafe-fl* rest (at m (unsafe-fx+ start i))))))
      (down (unsafe-fx+ i 1) (unsafe-fx+ start n))))
  (let up ([i (unsafe-fx- n 1)] [start (unsafe-fx* n (unsafe-fx- n 1))])
    (unless (unsafe-fx< i 0)
      (let ([x (unsafe-fl* (at b i) (at m (unsafe-fx+ start i)))])
        (put! b i x)
        (let column ([j 0])
          (when (unsafe-fx< j i)
            (put! b j (unsafe-fl- (at b j) (unsafe-fl* x (at m (unsafe-fx+ start j)))))
            (column (unsafe-fx+ j 1)))))
      (up (unsafe-fx- i 1) (unsafe-fx- start n)))))

;; Undoes cholesky!: the diagonal before row `rows` was saved, the rest of it was not touched.
(define (restore! m n diagonal rows)
  (for ([i (in-range n)])
    (when (< i rows) (put! m (+ (* i n) i) (at diagonal i)))
    (for ([j (in-range i)])
      (put! m (+ (* i n) j) (at m (+ (* j n) i))))))
