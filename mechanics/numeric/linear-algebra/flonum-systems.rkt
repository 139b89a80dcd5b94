#lang racket/base
;; Linear systems of flonums, real or complex.
;;
;; Elimination with partial pivoting: the factors stay at most 1, so that
;; rounding errors hardly grow, in n³/3 multiplications.  Ranks and null spaces
;; need pivots from all that is left.
;;
;; When is a matrix singular, its entries being known to a rounding error ε each?
;; When changing every entry by that much may make it so, which takes a relative
;; change of about 1/ρ, ρ being the greatest eigenvalue of |A⁻¹||A| (Rump 1999).
;; That does not depend on the units of unknowns and equations, as a condition
;; number does.  It costs an inverse, and is asked only if a pivot became small.

(require "row-operations.rkt" "row-matrix.rkt"
         "../constants.rkt")

(provide floating-determinant floating-solutions floating-kernel triangular-inverse product
         ;; for systems that are nearly singular
         eliminate-fully! null-vector)

;; Matrices are vectors of rows, of which the copies made here are changed.
(define-row-operations (triangulate! clear-below! substitute-back!)
  0.0 zero? - * / magnitude >)

(define (inexact-rows rows) (rows-map exact->inexact rows))

;; ---------------------------------------------------------------------------
;; Square systems

(define (no-pivot? pivot k) (zero? pivot))

(define (floating-determinant matrix)
  (define rows (inexact-rows matrix))
  (define sign (triangulate! rows no-pivot?))
  (if sign
      (for/fold ([p sign]) ([row (in-vector rows)] [i (in-naturals)]) (* p (vector-ref row i)))
      0.0))

;; The rows of x with matrix · x = right, or 'singular.
(define (floating-solutions matrix right)
  (define rows (inexact-rows (beside matrix right)))
  (cond [(or (not (triangulate! rows no-pivot?))
             (and (suspicious? matrix rows) (singular-within-rounding? matrix)))
         'singular]
        [else (substitute-back! rows)]))

;; Of a matrix that is 0 below its diagonal.
(define (triangular-inverse rows)
  (substitute-back! (beside rows (unit-rows (vector-length rows) 1.0 0.0))))

;; ---------------------------------------------------------------------------
;; Singular within rounding

;; Is a pivot small beside its column of the matrix?
(define (suspicious? matrix triangle)
  (for/or ([k (in-range (vector-length matrix))])
    (define size
      (for/fold ([m 0.0]) ([row (in-vector matrix)]) (max m (magnitude (vector-ref row k)))))
    (<= (magnitude (entry triangle k k)) (* 1e-6 size))))

(define (singular-within-rounding? matrix)
  (define n (vector-length matrix))
  (define rows (inexact-rows (beside matrix (unit-rows n))))
  (or (not (triangulate! rows no-pivot?))
      (>= (* epsilon (greatest-eigenvalue (product (magnitudes (substitute-back! rows))
                                                   (magnitudes matrix))))
          1.0)))

(define (magnitudes rows) (rows-map (lambda (x) (exact->inexact (magnitude x))) rows))

(define (product a b)
  (define n (vector-length b))
  (for/vector #:length n ([row (in-vector a)])
    (build-vector n (lambda (j)
                      (for/fold ([s 0.0]) ([x (in-vector row)] [other (in-vector b)])
                        (+ s (* x (vector-ref other j))))))))

;; Of a matrix without negative entries and with a positive diagonal, by powers:
;; to a few per cent.
(define (greatest-eigenvalue rows)
  (for/fold ([v (make-vector (vector-length rows) 1.0)] [size 1.0] #:result size) ([_ 10])
    (define w
      (for/vector ([row (in-vector rows)]) (dot row v)))
    (define size (for/fold ([m 0.0]) ([x (in-vector w)]) (if (> x m) x m)))
    (values (for/vector ([x (in-vector w)]) (/ x size)) size)))

(define (dot v w) (for/fold ([s 0.0]) ([x (in-vector v)] [y (in-vector w)]) (+ s (* x y))))

;; ---------------------------------------------------------------------------
;; Rank and null space

;; Of a matrix of any shape -> rank and a list of vectors, of each of which the
;; component of greatest magnitude is 1.
(define (floating-kernel matrix)
  (define rows (scale-rows (inexact-rows matrix)))
  (define n (row-length rows))
  (define small (* 8 (max n (vector-length rows)) epsilon))
  (define-values (rank columns) (eliminate-fully! rows n small))
  (values rank
          (for/list ([place (in-range rank n)])
            (null-vector rows columns rank place))))

(define (scale-rows rows)
  (for/vector ([row (in-vector rows)])
    (define size (for/fold ([m 0.0]) ([x (in-vector row)]) (max m (magnitude x))))
    (if (zero? size) row (for/vector ([x (in-vector row)]) (/ x size)))))

;; Pivot k comes to be in row k and column columns[k]; entries up to `small` count as 0.
;; -> the number of pivots, at most `most`, and the columns
(define (eliminate-fully! rows most small)
  (define columns (build-vector (row-length rows) values))
  (let loop ([k 0])
    (define-values (i l size) (greatest-left rows columns k))
    (cond [(or (= k most) (<= size small)) (values k columns)]
          [else
           (exchange! rows k i)
           (exchange! columns k l)
           (clear-below! rows k (vector-ref columns k) 0)
           (loop (add1 k))])))

(define (greatest-left rows columns k)
  (for*/fold ([row #f] [place #f] [size 0.0])
             ([i (in-range k (vector-length rows))]
              [l (in-range k (vector-length columns))])
    (define m (magnitude (entry rows i (vector-ref columns l))))
    (if (> m size) (values i l m) (values row place size))))

;; 1 for the free unknown at this place, the pivots' unknowns from the last up.
(define (null-vector rows columns rank place)
  (define x (make-vector (vector-length columns) 0.0))
  (vector-set! x (vector-ref columns place) 1.0)
  (for ([k (in-range (sub1 rank) -1 -1)])
    (define row (vector-ref rows k))
    (define j (vector-ref columns k))
    (vector-set! x j (- 0.0 (/ (dot row x) (vector-ref row j)))))
  (define greatest
    (for/fold ([best 0.0]) ([y (in-vector x)]) (if (> (magnitude y) (magnitude best)) y best)))
  (for/vector #:length (vector-length x) ([y (in-vector x)]) (/ y greatest)))
