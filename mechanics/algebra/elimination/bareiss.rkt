#lang racket/base
;; Elimination without fractions (Bareiss 1968, after Jordan).
;;
;; Take a pivot p = aₖₖ and clear its column in every other row,
;;
;;     aᵢⱼ ← (aₖₖ aᵢⱼ - aᵢₖ aₖⱼ) / q,      q the pivot before (1 at first).
;;
;; By Sylvester's identity the entries are then minors of the matrix given: those
;; of the rows and columns of the pivots so far, with row i for that of a pivot
;; or column j for that of a pivot.  Hence the division is exact in any integral
;; domain, integers and polynomials too, and entries grow no faster than minors
;; must.  At the end every pivot row reads d xₚ + Σ aₚⱼ xⱼ = aₚ with the last pivot
;; d, which is the determinant but for a sign; solutions and null vectors are
;; read off.
;;
;; Polynomials modulo relations, like sin² + cos² = 1, cannot be divided like
;; that.  Their domain does not divide by q, and is handed every new row to put
;; it in order: a common divisor of its entries is taken out.
;;
;; Each pivot is the smallest entry left, in the row and column with the fewest
;; others (Markowitz), so that zeros stay and entries grow late.

(require "../../numeric/linear-algebra/row-matrix.rkt")

(provide (struct-out domain) (struct-out echelon) eliminate
         integer-domain number-domain)

;; zero? : entry -> boolean;  size : entry not 0 -> number, small is better
;; cross : a b c d q -> (a b - c d)/q, which is exact, if tidy is #f; else a b - c d
;; tidy : vector of results of cross -> entries in the same ratio
(struct domain (zero one zero? size cross tidy) #:authentic)

;; rows : vector of vectors, those of the pivots first;  rank : how many these are
;; order : original numbers of the rows;  columns : vector, that of each pivot first
;; pivot : the last one
(struct echelon (rows rank order columns pivot) #:authentic)

(define (domain-of-numbers size divide)
  (domain 0 1 (lambda (x) (eqv? x 0)) size
          (lambda (a b c d q) (divide (- (* a b) (* c d)) q))
          #f))

(define integer-domain (domain-of-numbers integer-length quotient))
(define number-domain (domain-of-numbers (lambda (x) 1) /))

;; Pivots are taken from the first `width` columns.
(define (eliminate D matrix width)
  (define rows (for/vector #:length (vector-length matrix) ([row (in-vector matrix)]) row))
  (define order (count-up (vector-length rows)))
  (define columns (count-up width))
  (let loop ([k 0] [previous (domain-one D)])
    (define-values (i l) (find-pivot D rows columns k))
    (cond [i
           (exchange! rows k i)
           (exchange! order k i)
           (exchange! columns k l)
           (loop (add1 k) (clear-column! D rows k (vector-ref columns k) previous))]
          [else (echelon rows k order columns previous)])))

(define (count-up n) (build-vector n values))

;; Clears column j in all rows but k; -> the pivot.
(define (clear-column! D rows k j q)
  (define top (vector-ref rows k))
  (for ([row (in-vector rows)] [i (in-naturals)] #:unless (= i k))
    (unless (and (domain-tidy D) ((domain-zero? D) (vector-ref row j)))
      (vector-set! rows i (cleared-row D row top j q))))
  (vector-ref top j))

(define (cleared-row D row top j q)
  (define cross (domain-cross D))
  (define p (vector-ref top j))
  (define a (vector-ref row j))
  (define new
    (for/vector #:length (vector-length row) ([x (in-vector row)] [t (in-vector top)])
      (cross p x a t q)))
  (if (domain-tidy D) ((domain-tidy D) new) new))

;; ---------------------------------------------------------------------------
;; Pivots

;; row; place : of the column; size : of the entry there
(struct candidate (row place size) #:authentic)

;; -> row and place of the column, or #f #f: all that is left is zero.
(define (find-pivot D rows columns k)
  (define candidates (pivot-candidates D rows columns k))
  (define row-counts (make-vector (vector-length rows) 0))
  (define place-counts (make-vector (vector-length columns) 0))
  (for ([c (in-list candidates)])
    (increment! row-counts (candidate-row c))
    (increment! place-counts (candidate-place c)))
  (define (fill c)
    (* (sub1 (vector-ref row-counts (candidate-row c)))
       (sub1 (vector-ref place-counts (candidate-place c)))))
  (define (lighter? a b)
    (define d (- (candidate-size a) (candidate-size b)))
    (or (< d 0) (and (eqv? d 0) (< (fill a) (fill b)))))
  (define best
    (for/fold ([best #f]) ([c (in-list candidates)])
      (if (or (not best) (lighter? c best)) c best)))
  (if best (values (candidate-row best) (candidate-place best)) (values #f #f)))

(define (pivot-candidates D rows columns k)
  (for*/list ([i (in-range k (vector-length rows))]
              [l (in-range k (vector-length columns))]
              [x (in-value (entry rows i (vector-ref columns l)))]
              #:unless ((domain-zero? D) x))
    (candidate i l ((domain-size D) x))))

(define (increment! v i) (vector-set! v i (add1 (vector-ref v i))))
