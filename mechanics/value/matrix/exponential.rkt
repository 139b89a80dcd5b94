#lang racket/base
;; The exponential of a square matrix, 1 + A + A²/2! + ⋯.
;;
;; One that is nilpotent, Aⁿ = 0 for its n rows, is summed exactly, whatever its entries;
;; one that is diagonal has the exponentials of these.  Of other numbers A is halved until its
;; norm is below 1/2, the series summed to rounding, and the sum squared as often as A was
;; halved (Moler and Van Loan, SIAM Review 45, 2003, method 3).

(require "row-products.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt" "../../generic/kind.rkt" "../../generic/rounding.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide rows-exponential)

;; rows : a vector of rows, as many as they are long
(define (rows-exponential rows)
  (cond [(diagonal? rows) (diagonal-exponential rows)]
        [(nilpotent-powers rows) => (lambda (powers) (sum-of-powers (vector-length rows) powers))]
        [(all-entries? numeric? rows) (by-squaring (rows-map g:exact->inexact rows))]
        [else (raise-no-formula rows)]))

(define (add-rows a b) (rows-combine g:+ a b))

(define (scale-rows c rows) (rows-map (lambda (x) (g:* c x)) rows))

;; A number, of any precision or being differentiated
(define (numeric? x) (number? (comparand x)))

;; ---------------------------------------------------------------------------

(define (diagonal? rows)
  (for*/and ([(row i) (in-indexed-vector rows)] [(x j) (in-indexed-vector row)])
    (or (= i j) (g:zero? x))))

(define (in-indexed-vector v) (in-parallel (in-vector v) (in-naturals)))

(define (diagonal-exponential rows)
  (for/vector ([(row i) (in-indexed-vector rows)])
    (for/vector ([(x j) (in-indexed-vector row)])
      (if (= i j) (g:exp x) 0))))

;; A, A², ... up to the last that is not zero; #f where Aⁿ is not.
(define (nilpotent-powers rows)
  (define n (vector-length rows))
  (let next ([power rows] [powers '()])
    (cond [(all-entries? g:zero? power) (reverse powers)]
          [(= (length powers) (sub1 n)) #f]
          [else (next (rows-product power rows) (cons power powers))])))

(define (sum-of-powers n powers)
  (for/fold ([sum (unit-rows n)] [factorial 1] #:result sum)
            ([power (in-list powers)] [k (in-naturals 1)])
    (define k! (* k factorial))
    (values (add-rows sum (scale-rows (/ 1 k!) power)) k!)))

;; ---------------------------------------------------------------------------

(define (by-squaring rows)
  (define norm
    (for/fold ([most 0.0]) ([row (in-vector rows)])
      (max most (for/sum ([x (in-vector row)]) (magnitude (comparand x))))))
  (unless (< norm +inf.0)
    (complain 'exp "expected a matrix of finite numbers; given ~a" (rows->text rows)))
  (define halvings (max 0 (+ 2 (integer-length (inexact->exact (ceiling norm))))))
  (for/fold ([e (series-sum (scale-rows (expt 2.0 (- halvings)) rows))])
            ([_ (in-range halvings)])
    (rows-product e e)))

;; Below a norm of 1/2 the terms after the sixteenth are lost in rounding.
(define (series-sum rows)
  (for/fold ([sum (add-rows (unit-rows (vector-length rows)) rows)] [term rows] #:result sum)
            ([k (in-range 2 17)])
    (define next (scale-rows (/ 1.0 k) (rows-product term rows)))
    (values (add-rows sum next) next)))

;; ---------------------------------------------------------------------------

(define (raise-no-formula rows)
  (complain 'exp
            (string-append "the exponential of a matrix is known if it is diagonal or nilpotent, "
                           "or if its entries are numbers; given ~a")
            (rows->text rows)))

(define (rows->text rows)
  (value->text (cons 'matrix-by-rows
                     (for/list ([row (in-vector rows)]) (cons 'list (vector->list row))))))
